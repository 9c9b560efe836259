#include <gtest/gtest.h>

#include "SmoothWarp.h"

using namespace mien;

namespace {

class SmoothWarps : public testing::TestWithParam<int> {};

}  // namespace

TEST_P(SmoothWarps, MeetsItsPoints) {
  std::srand(1);
  const SmoothWarp::Points from = 100.0 * SmoothWarp::Points::Random(30, GetParam()),
                           to = 100.0 * SmoothWarp::Points::Random(30, GetParam());
  const SmoothWarp warp(from, to);
  ASSERT_TRUE(warp.sound());
  for (int i = 0; i < 30; ++i) EXPECT_LT((warp(from.row(i).transpose()) - to.row(i).transpose()).norm(), 1e-8);
}

TEST_P(SmoothWarps, ReproducesAffineMaps) {
  std::srand(2);
  const int d = GetParam();
  const SmoothWarp::Points from = 50.0 * SmoothWarp::Points::Random(20, d);
  const Eigen::MatrixXd affine = Eigen::MatrixXd::Random(d, d);
  const SmoothWarp warp(from, from * affine.transpose());
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd p = 300.0 * Eigen::VectorXd::Random(d);
    EXPECT_LT((warp(p) - affine * p).norm(), 1e-8);
    EXPECT_LT((warp.derivative(p) - affine).norm(), 1e-9);
  }
}

TEST_P(SmoothWarps, DerivativeIsThatOfTheMap) {
  std::srand(4);
  const int d = GetParam();
  const SmoothWarp::Points from = SmoothWarp::Points::Random(15, d),
                           to = from + 0.1 * SmoothWarp::Points::Random(15, d);
  const SmoothWarp warp(from, to, 0.01);
  const Eigen::VectorXd p = Eigen::VectorXd::Constant(d, 0.123);
  constexpr double h = 1e-6;
  for (int k = 0; k < d; ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(d, k);
    EXPECT_LT(((warp(p + step) - warp(p - step)) / (2.0 * h) - warp.derivative(p).col(k)).norm(), 1e-7);
  }
}

TEST_P(SmoothWarps, PointsThatDetermineNothingAreTold) {
  const SmoothWarp::Points same = SmoothWarp::Points::Ones(10, GetParam());
  EXPECT_FALSE(SmoothWarp(same, same).sound());
}

INSTANTIATE_TEST_SUITE_P(InPlaneAndSpace, SmoothWarps, testing::Values(2, 3));
