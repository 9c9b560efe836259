#include <gtest/gtest.h>

#include <random>

#include "SyntheticHead.h"
#include "TriangleDistance.h"
#include "TriangleTree.h"

using namespace mien;

namespace {

/// Triangles anywhere, every fifth of them without area: a line, or a point.
TriangleMesh scattered(int count) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> coordinate(-50.0, 50.0), edge(-8.0, 8.0);
  TriangleMesh mesh;
  mesh.vertices.resize(3 * count, 3);
  mesh.triangles.resize(count, 3);
  for (int t = 0; t < count; ++t) {
    const Eigen::RowVector3d a(coordinate(random), coordinate(random), coordinate(random));
    const Eigen::RowVector3d b = a + Eigen::RowVector3d(edge(random), edge(random), edge(random));
    const Eigen::RowVector3d c = a + Eigen::RowVector3d(edge(random), edge(random), edge(random));
    const Eigen::RowVector3d on = a + 0.3 * (b - a), past = a + 2.0 * (b - a);
    mesh.vertices.row(3 * t) = a;
    mesh.vertices.row(3 * t + 1) = t % 20 == 5 ? a : b;
    mesh.vertices.row(3 * t + 2) = t % 20 == 0 ? on : t % 20 == 5 ? a : t % 20 == 10 ? past : t % 20 == 15 ? b : c;
    mesh.triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  return mesh;
}

void expectNearest(const TriangleMesh& mesh, double reach) {
  const TriangleTree tree(mesh);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d place(coordinate(random), coordinate(random), coordinate(random));
    const TriangleTree::Nearest found = tree.nearest(place);
    ASSERT_GE(found.triangle, 0);
    EXPECT_NEAR(std::sqrt(found.squared), distanceTo(mesh, place), 1e-9);
    EXPECT_NEAR((place - found.point).squaredNorm(), found.squared, 1e-9);
    EXPECT_NEAR(found.shares.sum(), 1.0, 1e-12);
    EXPECT_GE(found.shares.minCoeff(), 0.0);
    Eigen::Vector3d mixed = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
      mixed += found.shares[k] * mesh.vertices.row(mesh.triangles(found.triangle, k)).transpose();
    EXPECT_LT((mixed - found.point).norm(), 1e-9);
  }
}

}  // namespace

TEST(TriangleTree, FindsWhatSearchingAllTrianglesFinds) {
  expectNearest(scattered(400), 80.0);
  expectNearest(ellipticHead().mesh(), 150.0);
  expectNearest(scattered(1), 80.0);
}

TEST(TriangleTree, SharesAreExactlyZeroOnEdgesAndCorners) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, 3);
  mesh.vertices << 0, 0, 0, 4, 0, 0, 0, 3, 0;
  mesh.triangles.resize(1, 3);
  mesh.triangles << 0, 1, 2;
  const TriangleTree tree(mesh);
  EXPECT_EQ(tree.nearest({-1, -2, 5}).shares, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(tree.nearest({9, -1, 5}).shares, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(tree.nearest({1, -2, 5}).shares, Eigen::Vector3d(0.75, 0.25, 0));
  EXPECT_EQ(tree.nearest({3, 3, 1}).shares[0], 0.0);
  EXPECT_GT(tree.nearest({1, 1, 1}).shares.minCoeff(), 0.0);
}

TEST(TriangleTree, WithoutTrianglesNothingIsNear) {
  const TriangleTree::Nearest found = TriangleTree(TriangleMesh()).nearest({1, 2, 3});
  EXPECT_EQ(found.triangle, -1);
  EXPECT_TRUE(std::isinf(found.squared));
}
