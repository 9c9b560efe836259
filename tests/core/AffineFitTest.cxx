#include <gtest/gtest.h>

#include <cmath>

#include "AffineFit.h"

using namespace mien;

TEST(AffineFit, AffineMapsAreFound) {
  std::srand(5);
  const AffineFit::Points from = 100.0 * AffineFit::Points::Random(12, 2);
  Eigen::Matrix2d linear;
  linear << 2.0, 0.3, -0.5, 1.5;
  const Eigen::RowVector2d shift(40.0, -7.0);
  const AffineFit fit(from, (from * linear.transpose()).rowwise() + shift);
  ASSERT_TRUE(fit.sound());
  EXPECT_NEAR(fit.scale(), std::sqrt(3.15), 1e-12);
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector2d p = from.row(i).transpose(), expected = linear * p + shift.transpose();
    EXPECT_LT((fit(p) - expected).norm(), 1e-10);
  }
}

/// What is left over is orthogonal to 1, x and y: the condition of the least sum of squares.
TEST(AffineFit, TheSumOfSquaresIsLeast) {
  std::srand(6);
  const AffineFit::Points from = 50.0 * AffineFit::Points::Random(20, 2), to = 50.0 * AffineFit::Points::Random(20, 2);
  const AffineFit fit(from, to);
  Eigen::Matrix<double, 3, 2> sums = Eigen::Matrix<double, 3, 2>::Zero();
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector2d p = from.row(i).transpose();
    sums += Eigen::Vector3d(1.0, p.x(), p.y()) * (to.row(i) - fit(p).transpose());
  }
  EXPECT_LT(sums.cwiseAbs().maxCoeff(), 1e-9);
}

TEST(AffineFit, PointsOnALineDetermineNone) {
  AffineFit::Points line(5, 2);
  for (int i = 0; i < 5; ++i) line.row(i) << i, 2.0 * i + 1.0;
  EXPECT_FALSE(AffineFit(line, line).sound());
  EXPECT_FALSE(AffineFit(line.topRows(2), line.topRows(2)).sound());
  line(2, 0) = 40.0;
  EXPECT_TRUE(AffineFit(line, line).sound());
}
