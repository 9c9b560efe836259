#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "MeshWarp.h"

using namespace mien;

namespace {

std::vector<double> rowOf(const MeshWarp& warp, int row) {
  std::vector<double> x(warp.warpedSize().width + 1);
  warp.rowBorders(row, 0, static_cast<int>(x.size()), x.data());
  return x;
}

std::string faultOf(const WarpMesh& source, const WarpMesh& target) {
  MeshWarp warp;
  return warp.set(source, target, {100, 80}, {100, 80});
}

}  // namespace

TEST(MeshWarp, AMeshOntoItselfMovesNothing) {
  WarpMesh mesh = evenMesh(7, 7, 100, 80);
  mesh.x(3, 2) += 5.0;
  mesh.y(2, 4) -= 6.0;
  MeshWarp warp;
  ASSERT_EQ(warp.set(mesh, mesh, {100, 80}, {100, 80}), "");
  for (int row = 0; row < 80; ++row) {
    const std::vector<double> x = rowOf(warp, row);
    for (int i = 0; i <= 100; ++i) EXPECT_NEAR(x[i], i, 1e-11);
  }
}

TEST(MeshWarp, MeshesAreScaledToTheirImages) {
  MeshWarp warp;
  ASSERT_EQ(warp.set(evenMesh(3, 5, 10, 10), evenMesh(3, 5, 7, 9), {100, 80}, {300, 40}), "");
  const std::vector<double> x = rowOf(warp, 10);
  for (int i = 0; i <= 300; ++i) EXPECT_NEAR(x[i], i / 3.0, 1e-11);
  std::vector<double> y(41);
  warp.columnBorders(17, 0, 41, y.data());
  for (int i = 0; i <= 40; ++i) EXPECT_NEAR(y[i], 2.0 * i, 1e-11);
}

/// Slanted columns and rows are lines, and an affine map of a mesh is that map.
TEST(MeshWarp, AffineMapsAreReproduced) {
  const WarpMesh from = evenMesh(4, 4, 100, 80);
  WarpMesh to = from;
  to.x = 10.0 + 0.7 * from.x.array() + 0.1 * from.y.array();
  to.y = 5.0 + 0.8 * from.y.array();
  MeshWarp warp;
  ASSERT_EQ(warp.set(from, to, {100, 80}, {100, 80}), "");
  const std::vector<double> x = rowOf(warp, 40);
  for (int i = 20; i < 80; ++i) EXPECT_NEAR(x[i], (i - 10.0 - 0.1 * 40.5) / 0.7, 1e-10);
}

TEST(MeshWarp, OutsideTheTargetTheBorderIsRepeated) {
  const WarpMesh from = evenMesh(3, 3, 100, 80);
  WarpMesh to = from;
  to.x = 30.0 + 0.4 * from.x.array();
  MeshWarp warp;
  ASSERT_EQ(warp.set(from, to, {100, 80}, {100, 80}), "");
  const std::vector<double> x = rowOf(warp, 0);
  EXPECT_EQ(x[0], 0.0);
  EXPECT_EQ(x[29], 0.0);
  EXPECT_EQ(x[71], 100.0);
  EXPECT_EQ(warp.firstColumnAt(0), 30.0);
  EXPECT_EQ(warp.lastColumnAt(0), 70.0);
}

/// A head that leans has its left border lower than its right one; at the back both must be one.
TEST(MeshWarp, ClosedColumnsMeetAtTheBack) {
  WarpMesh from = evenMesh(4, 5, 100, 80), to = from;
  from.y = 20.0 + 0.5 * from.y.array() + 0.15 * from.x.array();
  to.x = 25.0 + 0.5 * from.x.array();
  MeshWarp warp;
  std::vector<double> first(81), last(81), border(81), inside(81);
  for (const bool closed : {true, false}) {
    ASSERT_EQ(warp.set(from, to, {100, 80}, {200, 80}, closed), "");
    warp.columnBorders(0, 0, 81, first.data());
    warp.columnBorders(199, 0, 81, last.data());
    double seam = 0.0;
    for (int i = 0; i <= 80; ++i) seam = std::max(seam, std::abs(first[i] - last[i]));
    EXPECT_TRUE(closed ? seam < 0.3 : seam > 14.0) << seam;
    warp.columnBorders(151, 0, 81, border.data());
    warp.columnBorders(148, 0, 81, inside.data());
    for (int i = 0; i <= 80; ++i) EXPECT_NEAR(border[i], inside[i], 0.5) << "from the mesh's border on";
  }
}

TEST(MeshWarp, FoldedMeshesAreRefusedByName) {
  const WarpMesh even = evenMesh(4, 5, 100, 80);
  WarpMesh folded = even;
  folded.x(2, 1) = folded.x(2, 2) + 1.0;
  EXPECT_NE(faultOf(folded, even).find("the source mesh is folded: columns 2 and 3 cross in row 3"), std::string::npos);
  folded = even;
  folded.y(1, 4) = folded.y(2, 4);
  EXPECT_NE(faultOf(even, folded).find("the target mesh is folded: rows 2 and 3 cross in column 5"), std::string::npos);
}

/// In every row of points the columns are in order, but the second bends right at y = 20 and the third only at y = 60.
TEST(MeshWarp, SplinesThatCrossBetweenPointsAreRefused) {
  WarpMesh crossing = evenMesh(3, 4, 100, 80);
  crossing.x.col(1) << 20.0, 58.0, 20.0;
  crossing.x.col(2) << 30.0, 59.0, 30.0;
  crossing.y(1, 1) = 20.0;
  crossing.y(1, 2) = 60.0;
  const std::string fault = faultOf(crossing, evenMesh(3, 4, 100, 80));
  EXPECT_NE(fault.find("the source mesh is folded: columns 2 and 3 cross at y = "), std::string::npos) << fault;
}

TEST(MeshWarp, MeshesOfTwoSizesAreRefused) {
  EXPECT_NE(faultOf(evenMesh(4, 5, 100, 80), evenMesh(5, 4, 100, 80)).find("4 x 5"), std::string::npos);
  EXPECT_NE(faultOf(evenMesh(2, 2, 100, 80), WarpMesh(1, 2, 100, 80)).find("2 to 256"), std::string::npos);
  WarpMesh broken = evenMesh(3, 3, 100, 80);
  broken.x(1, 1) = NAN;
  EXPECT_NE(faultOf(broken, evenMesh(3, 3, 100, 80)).find("not finite"), std::string::npos);
}
