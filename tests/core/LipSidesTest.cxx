#include "LipSides.h"

#include <gtest/gtest.h>

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

TEST(LipSides, JumpsAcrossTheSlitOnly) {
  const SlitSquare square;
  const auto sides = lipSides(square.vertices, square.edges, {square.at(10, 10)}, {square.below(10)}, 5.0);
  EXPECT_EQ(sides[square.at(10, 10)], 1.0);
  EXPECT_EQ(sides[square.below(10)], -1.0);
  EXPECT_EQ(sides[square.at(5, 10)], 0.0) << "the corner";
  EXPECT_EQ(sides[square.at(2, 10)], 0.0) << "beside the corner";
  EXPECT_GT(sides[square.at(10, 7)], 0.99);
  EXPECT_LT(sides[square.at(10, 13)], -0.99);
  // An edge of length 1 changes each of two distances by at most 1.
  for (const auto& edge : square.edges) EXPECT_LE(std::abs(sides[edge[0]] - sides[edge[1]]), 0.4 + 1e-12);
}

TEST(LipSides, WhatIsNotConnectedHasNoSide) {
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> vertices(3, 3);
  vertices << 0, 0, 0, 1, 0, 0, 5, 0, 0;
  EXPECT_EQ(lipSides(vertices, {{0, 1}}, {0}, {1}, 1.0), (std::vector<LipSide>{1.0, -1.0, 0.0}));
}
