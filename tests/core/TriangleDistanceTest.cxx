#include <gtest/gtest.h>

#include "SyntheticHead.h"
#include "TriangleDistance.h"

using namespace mien;

TEST(TriangleDistance, IsThatToFaceEdgeOrCorner) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 3);
  mesh.vertices << 0, 0, 0, 4, 0, 0, 0, 3, 0;
  mesh.triangles.resize(1, 3);
  mesh.triangles << 0, 1, 2;
  EXPECT_DOUBLE_EQ(distanceTo(mesh, {1, 1, -2}), 2.0) << "face";
  EXPECT_DOUBLE_EQ(distanceTo(mesh, {2, -3, 4}), 5.0) << "edge";
  EXPECT_DOUBLE_EQ(distanceTo(mesh, {7, -4, 12}), 13.0) << "corner";
  EXPECT_DOUBLE_EQ(distanceTo(mesh, {2 + 0.6, 1.5 + 0.8, 0}), 1.0) << "hypotenuse";
  mesh.vertices.row(2) = mesh.vertices.row(0);
  EXPECT_DOUBLE_EQ(distanceTo(mesh, {2, 3, 4}), 5.0) << "a triangle without area is a line";
  EXPECT_TRUE(std::isinf(distanceTo(TriangleMesh(), {0, 0, 0})));
}

TEST(TriangleDistance, GrowsWithTheHeightAboveAHead) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  for (const double height : {0.0, 0.5, 3.0})
    EXPECT_NEAR(distanceTo(mesh, head.axis.point(0.0, 1.0, height + head.radius(0.0, 1.0))), height, 0.03);
}
