#include <gtest/gtest.h>

#include <random>

#include "QuadraticFit.h"
#include "SampleMap.h"

using namespace mien;

namespace {

PlanePoints randomPoints(int count, const Eigen::RowVector2d& centre, double size) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-size, size);
  PlanePoints points(count, 2);
  for (int i = 0; i < count; ++i) points.row(i) = centre + Eigen::RowVector2d(place(random), place(random));
  return points;
}

PlanePoints mapped(const QuadraticMap& map, const PlanePoints& points) {
  PlanePoints result(points.rows(), 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) result.row(i) = map.apply(points.row(i));
  return result;
}

}  // namespace

TEST(QuadraticFit, ReturnsTheMapThatMadeThePoints) {
  for (const int count : {6, 7, 40}) {
    const PlanePoints before = randomPoints(count, {1.0, -2.6}, 0.5);
    const QuadraticFit fit = fitQuadraticMap(before, mapped(sampleMap(), before));
    EXPECT_EQ(fit.rank, 6);
    EXPECT_LT((fit.map.coefficients - sampleMap().coefficients).cwiseAbs().maxCoeff(), 1e-10) << count;
    EXPECT_LT(fit.rms, 1e-13);
  }
}

TEST(QuadraticFit, FewPointsLeanOnTheAffineFit) {
  QuadraticMap affine = sampleMap();
  affine.coefficients.leftCols<3>().setZero();
  for (const int count : {3, 4, 5}) {
    const PlanePoints before = randomPoints(count, {-1.0, 0.35}, 0.4);
    const QuadraticFit fit = fitQuadraticMap(before, mapped(affine, before));
    EXPECT_TRUE(fit.sparse());
    EXPECT_LT((fit.map.coefficients - affine.coefficients).cwiseAbs().maxCoeff(), 1e-9) << count;
  }
}

TEST(QuadraticFit, OnePointIsAShift) {
  PlanePoints before(1, 2), after(1, 2);
  before << 1.0, -2.0;
  after << 1.1, -1.8;
  const QuadraticFit fit = fitQuadraticMap(before, after);
  EXPECT_EQ(fit.rank, 1);
  EXPECT_LT((fit.map.apply({1.0, -2.0}) - Eigen::Vector2d(1.1, -1.8)).norm(), 1e-12);
  EXPECT_LT((fit.map.jacobian({1.0, -2.0}) - Eigen::Matrix2d::Identity()).norm(), 1e-12);
}

TEST(QuadraticFit, PointsOnALineDoNotRunAwayBesideIt) {
  PlanePoints before(12, 2);
  for (int i = 0; i < 12; ++i) before.row(i) << 0.1 * i - 0.6, -2.6 + 0.02 * i;
  PlanePoints after = before;
  after.col(1).array() += 0.1;
  const QuadraticFit fit = fitQuadraticMap(before, after);
  EXPECT_TRUE(fit.sparse());
  EXPECT_LT((fit.map.apply({0.0, -3.2}) - Eigen::Vector2d(0.0, -3.1)).norm(), 1e-9);
}

TEST(QuadraticFit, ReportsWhatIsLeftOver) {
  const PlanePoints before = randomPoints(60, {0.0, 0.0}, 1.0);
  PlanePoints after = before;
  for (int i = 0; i < 60; ++i) after(i, 0) += i % 2 ? 0.01 : -0.01;
  const QuadraticFit fit = fitQuadraticMap(before, after);
  EXPECT_NEAR(fit.largestDisplacement, 0.01, 1e-15);
  EXPECT_LT(fit.rms, 0.01);
  EXPECT_GT(fit.rms, 0.009);
}
