#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "CsvRows.h"
#include "FaceFiles.h"
#include "Program.h"
#include "vtkPDEPatchFilter.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLStructuredGridReader.h"

namespace {

/// Circles of these radii, one above the other, as closed polylines of 16 points.
mien::ClosedCurves circles(const std::vector<double>& radii) {
  mien::ClosedCurves curves(static_cast<int>(radii.size()), 16);
  for (int c = 0; c < curves.count; ++c)
    for (int j = 0; j < 16; ++j)
      curves.curve(c).row(j) << radii[c] * std::cos(j * M_PI / 8), 10.0 * c, radii[c] * std::sin(j * M_PI / 8);
  return curves;
}

void writeCurves(const mien::ClosedCurves& curves, const std::string& name) {
  vtkNew<vtkPolyData> data;
  mien::writeClosedCurves(curves, data);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  writer->Write();
}

TEST(PatchCommand, GridHoldsWhatTheFilterComputes) {
  const TemporaryFolder folder;
  const mien::ClosedCurves curves = circles({5, 8, 3, 4});
  writeCurves(curves, folder.file("vase.vtp"));
  const Outcome outcome = runMien({"patch",        folder.file("vase.vtp"),
                                   "--condition",  "0",
                                   "--condition",  "0.2:0",
                                   "--condition",  "1:1",
                                   "--condition",  "1",
                                   "-a",           "2",
                                   "-N",           "3",
                                   "--resolution", "9x12",
                                   "--precision",  "double",
                                   "-o",           folder.file("vase.vts")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(folder.file("vase.vts").c_str());
  reader->Update();
  vtkNew<vtkPolyData> data;
  mien::writeClosedCurves(curves, data);
  vtkNew<vtkPDEPatchFilter> patch;
  patch->SetInputData(data);
  patch->AddCondition(0, 0);
  patch->AddCondition(0.2, 0);
  patch->AddCondition(1, 1);
  patch->AddCondition(1, 0);
  patch->SetSmoothing(2);
  patch->SetNumberOfModes(3);
  patch->SetResolution(9, 12);
  patch->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  patch->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 9 * 13);
  for (vtkIdType i = 0; i < 9 * 13; ++i) {
    double read[3], computed[3];
    reader->GetOutput()->GetPoint(i, read);
    patch->GetOutput()->GetPoint(i, computed);
    for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(read[axis], computed[axis]) << i;
  }
}

TEST(PatchCommand, TableBeginsAndEndsOnTheOuterCurves) {
  const TemporaryFolder folder;
  writeCurves(circles({5, 8}), folder.file("cone.vtp"));
  ASSERT_EQ(runMien({"patch", folder.file("cone.vtp"), "--resolution", "3x16", "-o", folder.file("cone.csv")}).exitCode,
            0);
  const auto rows = csvRows(folder.file("cone.csv"));
  ASSERT_EQ(rows.size(), 3u * 16u);
  for (int j = 0; j < 16; ++j)
    for (const auto& [row, radius, y] : {std::make_tuple(j, 5.0, 0.0), std::make_tuple(2 * 16 + j, 8.0, 10.0)}) {
      EXPECT_EQ(rows[row][0], "0");
      EXPECT_EQ(rows[row][1], row == j ? "0" : "1");
      EXPECT_NEAR(std::stod(rows[row][3]), radius * std::cos(j * M_PI / 8), 1e-12);
      EXPECT_NEAR(std::stod(rows[row][4]), y, 1e-12);
      EXPECT_NEAR(std::stod(rows[row][5]), radius * std::sin(j * M_PI / 8), 1e-12);
    }
}

TEST(PatchCommand, WrongValuesAndFilesAreRefused) {
  const TemporaryFolder folder;
  const std::string file = folder.file("c.vtp"), output = folder.file("x.vts");
  writeCurves(circles({5, 8}), file);
  const std::vector<std::pair<std::vector<std::string>, int>> cases = {
      {{file, "-a", "0"}, 2},
      {{file, "-N", "9"}, 2},
      {{file, "--condition", "0"}, 2},
      {{file, "--condition", "2"}, 2},
      {{file, "--condition", "1:x"}, 2},
      {{file, "--resolution", "1x3"}, 2},
      {{"none.vtp"}, 1},
      {{}, 2},
  };
  for (const auto& [options, code] : cases) {
    std::vector<std::string> arguments = {"patch", "-o", output};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = runMien(arguments);
    EXPECT_EQ(outcome.exitCode, code) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("mien: ", 0), 0u) << outcome.errors;
    EXPECT_FALSE(std::filesystem::exists(output));
  }
}

/// A fault of the file leaves with 1, one of the options with 2.
TEST(PatchCommand, CurvesThatMakeNoPatchAreAFaultOfTheFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("c.vtp"), output = folder.file("x.vts");
  writeCurves(circles({5, 8, 5}), file);
  const Outcome three = runMien({"patch", file, "-o", output});
  EXPECT_EQ(three.exitCode, 1);
  EXPECT_NE(three.errors.find(file + ": 3 curves make no patch"), std::string::npos) << three.errors;
  writeCurves(circles({5, 1e300}), file);
  const Outcome large = runMien({"patch", file, "-o", output});
  EXPECT_EQ(large.exitCode, 1);
  EXPECT_NE(large.errors.find("curve 2, point 0 (counted from 0) lies past 1e+15"), std::string::npos) << large.errors;
}

/// Four curves at thirds: the surface exceeds them as e^(a (N + 1) / 3), here 1e36 and 1e87 times.
TEST(PatchCommand, ASurfaceBeyondAllSenseIsRefusedAndOneBelowHasNumbersOnly) {
  const TemporaryFolder folder;
  writeCurves(circles({5, 8, 3, 4}), folder.file("c.vtp"));
  const std::string output = folder.file("x.vts");
  const Outcome refused = runMien({"patch", folder.file("c.vtp"), "-a", "100", "-o", output});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_NE(refused.errors.find("a = 100 and N = 5"), std::string::npos) << refused.errors;
  EXPECT_FALSE(std::filesystem::exists(output));
  ASSERT_EQ(runMien({"patch", folder.file("c.vtp"), "-a", "41", "-o", output}).exitCode, 0);
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(output.c_str());
  reader->Update();
  vtkDataArray* normals = reader->GetOutput()->GetPointData()->GetArray("Normals");
  ASSERT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i) {
    double point[3], normal[3];
    reader->GetOutput()->GetPoint(i, point);
    normals->GetTuple(i, normal);
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1.0, 1e-5) << i;
    for (const double x : point) ASSERT_TRUE(std::isfinite(x)) << i;
  }
}

TEST(PatchCommand, OpenLinesAreAFaultOfTheFile) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("c.vtp"), "<VTKFile type=\"PolyData\"><PolyData></PolyData></VTKFile>");
  const Outcome outcome = runMien({"patch", folder.file("c.vtp"), "-o", folder.file("x.vts")});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.errors.rfind("mien: " + folder.file("c.vtp") + ": ", 0), 0u) << outcome.errors;
}

}  // namespace
