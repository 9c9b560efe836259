#pragma once

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <string>

#include "ErrorCounter.h"
#include "vtkBoundaryCurveReader.h"

/// The curve reader says which file it refuses and why, and makes nothing of it.
inline void expectRefusedFace(const std::string& file, const std::string& word) {
  vtkNew<vtkBoundaryCurveReader> reader;
  ErrorCounter errors(reader);
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_NE(errors.first().find(file + ": "), std::string::npos) << errors.first();
  EXPECT_NE(errors.first().find(word), std::string::npos) << errors.first();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << word;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 0) << word;
}
