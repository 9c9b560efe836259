#include <gtest/gtest.h>

#include "QuadraticMap.h"
#include "SampleMap.h"

using namespace mien;

TEST(QuadraticMap, TheDefaultMovesNothing) {
  const Eigen::Vector2d point(1.7, -2.9);
  EXPECT_EQ(QuadraticMap().apply(point), point);
}

TEST(QuadraticMap, AppliesTheEquation) {
  const Eigen::Vector2d moved = sampleMap().apply({2.0, 3.0});
  EXPECT_NEAR(moved.x(), 0.3 * 4 - 0.2 * 6 + 0.1 * 9 + 1.2 * 2 + 0.05 * 3 - 0.3, 1e-15);
  EXPECT_NEAR(moved.y(), -0.15 * 4 + 0.25 * 6 + 0.4 * 9 - 0.1 * 2 + 0.9 * 3 + 0.2, 1e-14);
}

TEST(QuadraticMap, TheJacobianIsTheDerivative) {
  const Eigen::Vector2d point(0.7, -1.3);
  const double h = 1e-5;
  for (int i = 0; i < 2; ++i) {
    const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(i);
    const Eigen::Vector2d slope = (sampleMap().apply(point + step) - sampleMap().apply(point - step)) / (2 * h);
    EXPECT_LT((sampleMap().jacobian(point).col(i) - slope).norm(), 1e-10);
  }
}

TEST(QuadraticMap, MirroredIsTheMapOfTheMirroredFace) {
  const Eigen::Vector2d point(0.7, -1.3), other(-0.7, -1.3);
  const Eigen::Vector2d moved = sampleMap().apply(point), mirrored = sampleMap().mirrored().apply(other);
  EXPECT_NEAR(mirrored.x(), -moved.x(), 1e-15);
  EXPECT_NEAR(mirrored.y(), moved.y(), 1e-15);
  EXPECT_EQ(sampleMap().mirrored().mirrored().coefficients, sampleMap().coefficients);
}
