#include "FaceFiles.h"
#include "FaceLayout.h"
#include "FacePipeline.h"
#include "Program.h"

#include "vtkAlgorithm.h"

#include <gtest/gtest.h>

#include <charconv>
#include <sstream>

namespace {

/// Compares a table with curves, bit for bit.
void expectTable(const std::string& file, const mien::ClosedCurves& curves) {
  std::istringstream stream(readTextFile(file));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "curve,point,x,y,z");
  for (int index = 0; index < curves.count; ++index)
    for (int j = 0; j < curves.pointsPerCurve; ++j) {
      ASSERT_TRUE(std::getline(stream, line));
      std::istringstream cells(line);
      std::string name, point, coordinate;
      std::getline(cells, name, ',');
      std::getline(cells, point, ',');
      ASSERT_EQ(name, mien::FaceLayout::curveName(index));
      ASSERT_EQ(point, std::to_string(j));
      for (int axis = 0; axis < 3; ++axis) {
        std::getline(cells, coordinate, ',');
        ASSERT_EQ(std::stod(coordinate), curves.curve(index)(j, axis)) << line;
      }
    }
  EXPECT_FALSE(std::getline(stream, line));
}

TEST(CurvesCommand, TableHoldsTheNeutralCurves) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"curves", "-o", folder.file("c.csv")}).exitCode, 0);
  expectTable(folder.file("c.csv"), genericFace().curves);
}

TEST(CurvesCommand, TableHoldsTheAnimatedCurves) {
  const TemporaryFolder folder;
  const std::string demo = std::string(MIEN_DATA_DIR) + "/animation/demo.fap";
  ASSERT_EQ(runMien({"curves", "--fap", demo, "--frame", "60", "--set", "53=200,54=200", "-o", folder.file("c.csv")}).exitCode, 0);
  mien::FaceState state;
  state.fapFile = demo;
  state.frameChoice = mien::FaceState::FrameChoice::Number;
  state.frame = 60;
  state.fapValues = {{53, 200}, {54, 200}};
  mien::FacePipeline pipeline;
  pipeline.setState(state);
  ASSERT_EQ(pipeline.updateCurves(), "");
  mien::ClosedCurves curves;
  ASSERT_EQ(mien::readClosedCurves(vtkPolyData::SafeDownCast(pipeline.curves()->GetOutputDataObject(0)), curves), "");
  expectTable(folder.file("c.csv"), curves);
}

TEST(CurvesCommand, TheFileIsAFaceAgain) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"curves", "-o", folder.file("c.vtp")}).exitCode, 0);
  ASSERT_EQ(runMien({"curves", "--face", folder.file("c.vtp"), "-o", folder.file("c.csv")}).exitCode, 0);
  expectTable(folder.file("c.csv"), genericFace().curves);
  EXPECT_EQ(runMien({"surface", "--face", folder.file("c.vtp"), "--expression", "joy", "-o", folder.file("s.vtp")}).exitCode, 0);
}

TEST(CurvesCommand, UnknownEndingIsRefused) {
  const Outcome outcome = runMien({"curves", "-o", "c.vts"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find(".vtp, .csv"), std::string::npos) << outcome.errors;
}

}  // namespace
