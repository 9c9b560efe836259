#include <gtest/gtest.h>

#include "FaceFiles.h"
#include "Program.h"
#include "ReferenceData.h"

namespace {

TEST(AcquireCommand, WrongUseIsRefused) {
  const TemporaryFolder folder;
  const std::string output = folder.file("face.vtp");
  EXPECT_EQ(runMien({"acquire", "-o", output}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "--landmarks", "l.csv", "-o", folder.file("face.obj")}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "b.ply", "--landmarks", "l.csv", "-o", output}).exitCode, 2);
  EXPECT_EQ(runMien({"acquire", "a.ply", "--landmarks", "l.csv", "--points", "41", "-o", output}).exitCode, 2);
  const Outcome missing = runMien({"acquire", "a.ply", "--landmarks", "l.csv", "-o", output});
  EXPECT_EQ(missing.exitCode, 1);
  EXPECT_EQ(missing.errors.rfind("mien: a.ply: ", 0), 0u) << missing.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

TEST(AcquireCommand, MeasuresAHead) {
  MIEN_REQUIRE_REFERENCE("heads/landmarks68.csv");
  const TemporaryFolder folder;
  const std::string heads = std::string(MIEN_REFERENCE_DIR) + "/heads/";
  const Outcome outcome = runMien({"acquire", heads + "subject01_neutral.ply", "--landmarks", heads + "landmarks68.csv",
                                   "--points", "48", "-o", folder.file("face.vtp")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  vtkNew<vtkBoundaryCurveReader> reader;
  reader->SetFileName(folder.file("face.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 29 * 48);
}

}  // namespace
