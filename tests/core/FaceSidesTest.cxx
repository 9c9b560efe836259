#include <gtest/gtest.h>

#include "FaceSides.h"

using namespace mien;

namespace {

/// A square of 21 x 21 vertices one apart with a slit along row 10 between columns 5 and 15: the row is there twice.
struct SlitSquare {
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> vertices;
  MeshEdges edges;
  static constexpr int n = 21;

  SlitSquare() : vertices(n * n + 9, 3) {
    for (int i = 0; i < n * n; ++i) vertices.row(i) << i % n - 10, 10 - i / n, 0;
    for (int x = 6; x < 15; ++x) vertices.row(n * n + x - 6) = vertices.row(10 * n + x);
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        if (x + 1 < n) edges.push_back({at(x, y), at(x + 1, y)});
        if (y + 1 < n) edges.push_back({y == 10 ? below(x) : at(x, y), at(x, y + 1)});
      }
    for (int x = 5; x < 15; ++x) edges.push_back({below(x), below(x + 1)});
  }
  static int at(int x, int y) { return y * n + x; }
  static int below(int x) { return x > 5 && x < 15 ? n * n + x - 6 : at(x, 10); }
};

}  // namespace

TEST(FaceSides, JumpAcrossTheSlitOnly) {
  const SlitSquare square;
  const auto sides = slitSides(square.vertices, square.edges, {{square.at(10, 10)}, {square.below(10)}, 5.0, 8.0});
  EXPECT_EQ(sides[square.at(10, 10)], 1.0);
  EXPECT_EQ(sides[square.below(10)], -1.0);
  EXPECT_EQ(sides[square.at(5, 10)], 0.0) << "the corner";
  EXPECT_EQ(sides[square.at(2, 10)], 0.0) << "beside the corner";
  EXPECT_GT(sides[square.at(10, 9)], 0.9);
  EXPECT_LT(sides[square.at(10, 11)], -0.9);
  EXPECT_EQ(sides[square.at(10, 1)], 0.0) << "beyond the reach";
  // An edge of length 1 changes each of two distances by at most 1, and fading by at most 1.5 / 8.
  for (const auto& edge : square.edges) EXPECT_LE(std::abs(sides[edge[0]] - sides[edge[1]]), 0.4 + 1.5 / 8);
}

TEST(FaceSides, WhatIsNotConnectedHasNoSide) {
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> vertices(3, 3);
  vertices << 0, 0, 0, 1, 0, 0, 5, 0, 0;
  EXPECT_EQ(slitSides(vertices, {{0, 1}}, {{0}, {1}, 1.0, 9.0}), (std::vector<double>{1.0, -1.0, 0.0}));
}

TEST(FaceSides, LandmarksHaveTheirSide) {
  EXPECT_EQ(landmarkSide(62).lips, 1.0);
  EXPECT_EQ(landmarkSide(57).lips, -1.0);
  EXPECT_EQ(landmarkSide(48).lips, 0.0) << "a corner";
  EXPECT_EQ(landmarkSide(44).lids, 1.0);
  EXPECT_EQ(landmarkSide(41).lids, -1.0);
  EXPECT_EQ(landmarkSide(42).lids, 0.0) << "a corner";
  EXPECT_EQ(landmarkSide(20).lids, 0.0);
}
