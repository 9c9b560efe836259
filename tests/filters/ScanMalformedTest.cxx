#include <gtest/gtest.h>

#include <filesystem>

#include "PipelineErrors.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"

/// Cut off, beyond all bounds, no numbers, other bytes altogether.
TEST(ScanMalformed, EveryFileIsRefusedInOneSentenceThatNamesIt) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/scans")) {
    const std::string file = entry.path().string();
    vtkNew<vtkScanReader> reader;
    mien::PipelineErrors errors;
    errors.observe(reader);
    reader->SetFileName(file.c_str());
    reader->Update();
    const std::string fault = errors.first();
    EXPECT_EQ(fault.rfind(file + ":", 0), 0u) << file << ": " << fault;
    EXPECT_GT(fault.size(), file.size() + 25) << fault;
    EXPECT_EQ(fault.find('\n'), std::string::npos) << fault;
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << file;
    ++files;
  }
  EXPECT_EQ(files, 86);
}
