#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "FaceFiles.h"
#include "FacePipeline.h"
#include "FaceState.h"
#include "Program.h"
#include "SmallDisk.h"
#include "vtkCellData.h"
#include "vtkOBJReader.h"
#include "vtkPDEFaceFilter.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkSTLReader.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace {

/// patch, u, v, x, y, z of every line after the header.
std::vector<std::array<double, 6>> readTable(const std::string& file) {
  std::istringstream stream(readTextFile(file));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "patch,u,v,x,y,z");
  std::vector<std::array<double, 6>> rows;
  while (std::getline(stream, line)) {
    std::array<double, 6> row{};
    std::istringstream cells(line);
    std::string cell;
    for (double& value : row) std::getline(cells, cell, ','), value = std::stod(cell);
    rows.push_back(row);
  }
  return rows;
}

/// The share of cells that are wound so that they look away from the head's axis.
double outwardShare(vtkPolyData* surface) {
  int outwards = 0;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c) {
    vtkCell* cell = surface->GetCell(c);
    Eigen::Vector3d p[3];
    for (int i = 0; i < 3; ++i) surface->GetPoint(cell->GetPointId(i), p[i].data());
    const Eigen::Vector3d fromAxis(p[0].x(), 0.0, p[0].z() - 25.0);
    outwards += (p[1] - p[0]).cross(p[2] - p[0]).dot(fromAxis) > 0.0;
  }
  return static_cast<double>(outwards) / surface->GetNumberOfCells();
}

template <class Reader>
void expectPolygons(const std::string& ending, vtkIdType cells) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face." + ending);
  const Outcome outcome = runMien({"surface", "-o", file});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 1);
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), cells) << ending;
  EXPECT_GT(outwardShare(reader->GetOutput()), 0.95) << ending;
}

vtkIdType visibleCells(vtkStructuredGrid* grid) {
  vtkIdType count = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) count += grid->IsCellVisible(c);
  return count;
}

TEST(SurfaceCommand, TableHoldsWhatTheFilterComputes) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.csv");
  ASSERT_EQ(runMien({"surface", "-a", "1,2,3,4,5,6,7,8,9", "--resolution", "83x24", "-o", file}).exitCode, 0);
  mien::FaceState state;
  state.surface.smoothing = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  state.rows = 83;
  state.columns = 24;
  state.doublePrecision = true;
  mien::FacePipeline pipeline;
  pipeline.setState(state);
  ASSERT_EQ(pipeline.update(), "");
  vtkStructuredGrid* grid = pipeline.grid();
  const int lips = mien::RowLayout(83, false).upperLipRow();
  const auto rows = readTable(file);
  ASSERT_EQ(rows.size(), (83u + 7u) * 24u);  // seven seams beside the mouth are rows of two patches
  size_t next = 0;
  std::map<int, std::pair<double, double>> range;
  for (int row = 0, line = 0; row < 83; ++row) {
    const bool last = (line + 1) * 24u >= rows.size();
    const bool seam = !last && row != lips && rows[line * 24u][1] == 1.0 && rows[(line + 1) * 24u][1] == 0.0;
    for (int copy = 0; copy <= (seam ? 1 : 0); ++copy, ++line)
      for (int column = 0; column < 24; ++column, ++next) {
        double point[3];
        grid->GetPoint(row * 25 + column, point);
        for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(rows[next][3 + axis], point[axis]) << "line " << next;
        ASSERT_EQ(rows[next][2], 2.0 * M_PI * column / 24);
        auto& [low, high] = range.emplace(static_cast<int>(rows[next][0]), std::make_pair(1.0, 0.0)).first->second;
        low = std::min(low, rows[next][1]);
        high = std::max(high, rows[next][1]);
      }
  }
  EXPECT_EQ(next, rows.size());
  ASSERT_EQ(range.size(), 9u);
  for (const auto& [patch, ends] : range) EXPECT_EQ(ends, std::make_pair(0.0, 1.0)) << "patch " << patch;
}

TEST(SurfaceCommand, TableMeetsTheBoundaryCurves) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.csv");
  ASSERT_EQ(runMien({"surface", "--scheme", "four-curve", "-o", file}).exitCode, 0);
  const mien::FaceCurves face = genericFace();
  double largest = 0.0;
  int compared = 0;
  for (const auto& row : readTable(file))
    for (int i = 0; i < 4; ++i)
      if (std::abs(row[1] - i / 3.0) < 1e-12) {
        const int curve = mien::FaceLayout::firstCurve[static_cast<int>(row[0])] + i;
        const int j = static_cast<int>(std::lround(row[2] * 40 / (2 * M_PI)));
        largest =
            std::max(largest, (face.curves.curve(curve).row(j) - Eigen::RowVector3d(row[3], row[4], row[5])).norm());
        ++compared;
      }
  EXPECT_EQ(compared, 9 * 4 * 40);
  EXPECT_LT(largest, 1e-10);
}

TEST(SurfaceCommand, PolygonFormatsAreWoundOutwardsWithoutTheSlit) {
  mien::FacePipeline pipeline;
  ASSERT_EQ(pipeline.update(), "");
  const vtkIdType cells = visibleCells(pipeline.grid());
  ASSERT_LT(cells, 55 * 40);
  expectPolygons<vtkXMLPolyDataReader>("vtp", cells);
  expectPolygons<vtkPLYReader>("ply", cells);
  expectPolygons<vtkOBJReader>("obj", cells);
  const vtkIdType flat = 40 - (55 * 40 - cells);  // where the lips are one, cells between them make no triangle
  expectPolygons<vtkSTLReader>("stl", 2 * (cells - flat));
}

TEST(SurfaceCommand, EndingsInCapitalsAreWrittenLikeOthers) {
  const TemporaryFolder folder;
  for (const char* ending : {"PLY", "Ply", "OBJ", "STL", "OFF", "VTP", "VTS", "CSV"}) {
    const std::string file = folder.file(std::string("face.") + ending);
    const Outcome outcome = runMien({"surface", "-o", file});
    EXPECT_EQ(outcome.exitCode, 0) << ending << outcome.errors;
    EXPECT_GT(readTextFile(file).size(), 10000u) << ending;
    std::filesystem::remove(file);
  }
  EXPECT_EQ(entriesIn(folder.file("")), 0) << "nothing stays under another name";
}

TEST(SurfaceCommand, GridKeepsItsArraysAndHiddenCells) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.VTS");
  ASSERT_EQ(runMien({"surface", "--precision", "double", "-o", file}).exitCode, 0);
  vtkNew<vtkXMLStructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkStructuredGrid* grid = reader->GetOutput();
  EXPECT_EQ(grid->GetNumberOfPoints(), 56 * 41);
  EXPECT_EQ(grid->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_LT(visibleCells(grid), 55 * 40);
  EXPECT_TRUE(grid->GetPointData()->GetArray("Normals"));
  EXPECT_TRUE(grid->GetPointData()->GetArray("TextureCoordinates"));
  EXPECT_TRUE(grid->GetCellData()->GetArray("PatchId"));
}

TEST(SurfaceCommand, FAPsMoveTheSurface) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"surface", "-o", folder.file("a.csv")}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "--set", "51=0", "-o", folder.file("b.csv")}).exitCode, 0);
  ASSERT_EQ(runMien({"surface", "--expression", "joy:0.8", "-o", folder.file("c.csv")}).exitCode, 0);
  EXPECT_EQ(readTextFile(folder.file("a.csv")), readTextFile(folder.file("b.csv")));
  EXPECT_NE(readTextFile(folder.file("a.csv")), readTextFile(folder.file("c.csv")));
}

TEST(SurfaceCommand, UnknownEndingsAndPlacesThatCannotBeWrittenLeaveNothing) {
  const TemporaryFolder folder;
  const Outcome ending = runMien({"surface", "-o", folder.file("face.doc")});
  EXPECT_EQ(ending.exitCode, 2);
  EXPECT_NE(ending.errors.find(".vts, .vtp, .ply, .obj, .stl, .off, .csv"), std::string::npos) << ending.errors;
  EXPECT_EQ(runMien({"surface", "-o", folder.file("none/face.vtp")}).exitCode, 1);
  std::filesystem::create_directory(folder.file("folder.vtp"));
  EXPECT_EQ(runMien({"surface", "-o", folder.file("folder.vtp")}).exitCode, 1);
  EXPECT_EQ(runMien({"surface"}).exitCode, 2);
  EXPECT_EQ(entriesIn(folder.file("")), 1);
}

TEST(SurfaceCommand, AFailureLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.csv");
  writeTextFile(file, "precious");
  EXPECT_EQ(runMien({"surface", "-N", "99", "-o", file}).exitCode, 2);
  EXPECT_EQ(readTextFile(file), "precious");
}

TEST(SurfaceCommand, AFullDiskLeavesTheOldFileInEveryFormat) {
  const TemporaryFolder folder;
  for (const std::string ending : {"vts", "vtp", "ply", "obj", "stl", "off", "csv"}) {
    const std::string file = folder.file("face." + ending);
    writeTextFile(file, "precious");
    const SmallDisk disk(16384);
    const Outcome full = runMien({"surface", "-o", file});
    EXPECT_EQ(full.exitCode, 1) << ending;
    EXPECT_EQ(full.errors.find("mien: " + file + ": "), 0u) << full.errors;
    EXPECT_EQ(std::count(full.errors.begin(), full.errors.end(), '\n'), 1) << full.errors;
    EXPECT_EQ(readTextFile(file), "precious") << ending;
  }
  EXPECT_EQ(entriesIn(folder.file("")), 7) << "a temporary file is left";
}

}  // namespace
