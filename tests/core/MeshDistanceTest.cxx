#include <gtest/gtest.h>

#include "MeshDistance.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

/// A square of n x n cells in the plane z = 0 from 0 to n, without the cell at `hole`.
TriangleMesh sheet(int n, int hole = -1) {
  TriangleMesh mesh;
  mesh.vertices.resize((n + 1) * (n + 1), 3);
  mesh.triangles.resize(2 * (n * n - (hole >= 0)), 3);
  for (int r = 0; r <= n; ++r)
    for (int c = 0; c <= n; ++c) mesh.vertices.row(r * (n + 1) + c) << c, r, 0.0;
  int t = 0;
  for (int cell = 0; cell < n * n; ++cell) {
    if (cell == hole) continue;
    const int a = cell / n * (n + 1) + cell % n, b = a + 1, d = a + n + 1, e = d + 1;
    mesh.triangles.row(t++) << a, b, e;
    mesh.triangles.row(t++) << a, e, d;
  }
  return mesh;
}

/// Three vertices of its own for every triangle, as in an STL file.
TriangleMesh loose(const TriangleMesh& mesh) {
  TriangleMesh result;
  result.vertices.resize(3 * mesh.triangles.rows(), 3);
  result.triangles.resize(mesh.triangles.rows(), 3);
  for (int i = 0; i < 3 * mesh.triangles.rows(); ++i) {
    result.vertices.row(i) = mesh.vertices.row(mesh.triangles(i / 3, i % 3));
    result.triangles(i / 3, i % 3) = i;
  }
  return result;
}

}  // namespace

TEST(MeshDistance, TheRimIsWhereTheSurfaceEnds) {
  for (const TriangleMesh& mesh : {sheet(5), loose(sheet(5))}) {
    const MeshDistance distance(mesh);
    EXPECT_TRUE(distance.nearest({7.0, 2.4, 1.0}).onRim) << "beside the sheet";
    EXPECT_TRUE(distance.nearest({-1.0, -1.0, 0.0}).onRim) << "off its corner";
    EXPECT_FALSE(distance.nearest({2.3, 2.6, 1.0}).onRim) << "over a triangle";
    EXPECT_FALSE(distance.nearest({2.5, 2.5, 1.0}).onRim) << "over an inner edge";
    EXPECT_FALSE(distance.nearest({2.0, 3.0, -1.0}).onRim) << "over an inner corner";
  }
}

TEST(MeshDistance, AHoleHasARimToo) {
  const MeshDistance whole(sheet(5)), holed(sheet(5, 12));
  EXPECT_FALSE(whole.nearest({2.5, 2.4, 1.0}).onRim);
  EXPECT_TRUE(holed.nearest({2.5, 2.4, 1.0}).onRim);
  EXPECT_FALSE(holed.nearest({1.5, 2.4, 1.0}).onRim);
}

TEST(MeshDistance, AFoldedEdgeOfThreeTrianglesIsNoRim) {
  TriangleMesh mesh;
  mesh.vertices.resize(5, 3);
  mesh.vertices << 0, 0, 0, 0, 4, 0, 3, 2, 0, -3, 2, 0, 0, 2, 3;
  mesh.triangles.resize(3, 3);
  mesh.triangles << 0, 1, 2, 0, 1, 3, 1, 0, 4;
  EXPECT_FALSE(MeshDistance(mesh).nearest({0.0, 2.0, -1.0}).onRim);
  EXPECT_TRUE(MeshDistance(mesh).nearest({9.0, 2.0, 0.0}).onRim);
}

TEST(MeshDistance, InsideIsBehindWhateverTheCornersShare) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  const MeshDistance joined(mesh), apart(loose(mesh));
  const bool outwards = !joined.nearest(head.axis.point(0.3, 10.0, head.radius(0.3, 10.0) + 5.0)).isBehind;
  for (double azimuth = -3.1; azimuth < 3.1; azimuth += 0.37)
    for (double y = -60.0; y < 100.0; y += 13.0)
      for (const double height : {-20.0, -1.0, 1.0, 30.0})
        for (const MeshDistance* distance : {&joined, &apart}) {
          const auto found = distance->nearest(head.axis.point(azimuth, y, head.radius(azimuth, y) + height));
          EXPECT_EQ(found.isBehind == outwards, height < 0.0) << azimuth << " " << y << " " << height;
        }
}
