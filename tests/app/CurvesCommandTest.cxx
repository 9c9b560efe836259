#include <gtest/gtest.h>

#include <charconv>
#include <sstream>

#include "FaceFiles.h"
#include "FaceLayout.h"
#include "FacePipeline.h"
#include "Program.h"
#include "vtkAlgorithm.h"

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
  ASSERT_EQ(runMien({"curves", "--fap", demo, "--frame", "60", "--set", "53=200,54=200", "-o", folder.file("c.csv")})
                .exitCode,
            0);
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
  EXPECT_EQ(
      runMien({"surface", "--face", folder.file("c.vtp"), "--expression", "joy", "-o", folder.file("s.vtp")}).exitCode,
      0);
}

TEST(CurvesCommand, ACompactFaceServesWhereverCurvesDo) {
  const TemporaryFolder folder;
  const std::string face = folder.file("c.mienz");
  ASSERT_EQ(runMien({"curves", "--tolerance", "0.1mm", "--name", "Anna", "-o", face}).exitCode, 0);
  EXPECT_LE(std::filesystem::file_size(face), 1300u);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"surface", "--expression", "joy", "-o", folder.file("s.ply")},
        {"curves", "--set", "3=500", "-o", folder.file("d.vtp")},
        {"spectrum"},
        {"continuity"}}) {
    std::vector<std::string> all = arguments;
    all.insert(all.end(), {"--face", face});
    const Outcome outcome = runMien(all);
    EXPECT_EQ(outcome.exitCode, 0) << arguments[0] << ": " << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << arguments[0];
  }
  EXPECT_NE(runMien({"info", face}).output.find("feature points    60"), std::string::npos);
}

TEST(CurvesCommand, DamagedCompactFacesAndWrongTolerancesAreRefused) {
  const TemporaryFolder folder;
  const std::string face = folder.file("c.mienz");
  ASSERT_EQ(runMien({"curves", "-o", face}).exitCode, 0);
  writeTextFile(face, readTextFile(face).substr(0, 500));
  const Outcome outcome = runMien({"info", face});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.errors,
            "mien: " + face +
                ": the checksum is wrong: the file is damaged or cut off; copy the file again or write it anew\n");
  for (const char* const tolerance : {"0", "-1mm", "1e9", "0.1 furlong", "x"})
    EXPECT_EQ(runMien({"curves", "--tolerance", tolerance, "-o", folder.file("d.mienz")}).exitCode, 2) << tolerance;
  for (const char* const option : {"--tolerance", "--name"})
    EXPECT_EQ(runMien({"curves", option, "0.1mm", "-o", folder.file("d.vtp")}).exitCode, 2) << option;
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

TEST(CurvesCommand, UnknownEndingIsRefused) {
  const Outcome outcome = runMien({"curves", "-o", "c.vts"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find(".vtp, .csv"), std::string::npos) << outcome.errors;
}

}  // namespace
