#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "PiecewiseLinear.h"

using namespace mien;

// The example of a face animation table: FAP 6, borders -1000 0 500 1000, slopes (1,0,0), (0.9,0,0), (1.5,0,4).
TEST(PiecewiseLinear, EvaluatesTheExampleOfTheTable) {
  PiecewiseLinear intervals;
  ASSERT_EQ(intervals.setBorders({-1000, 0, 500, 1000}), "");
  const Eigen::Vector3d slopes[] = {{1, 0, 0}, {0.9, 0, 0}, {1.5, 0, 4}};
  const auto at = [&](double value) {
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    for (int i = 0; i < intervals.intervals(); ++i) shift += intervals.length(i, value) * slopes[i];
    return shift;
  };
  EXPECT_LT((at(300) - Eigen::Vector3d(270, 0, 0)).norm(), 1e-12);
  EXPECT_LT((at(600) - Eigen::Vector3d(600, 0, 400)).norm(), 1e-12);
  EXPECT_LT((at(-200) - Eigen::Vector3d(-200, 0, 0)).norm(), 1e-12);
  EXPECT_LT((at(1500) - Eigen::Vector3d(450 + 1500, 0, 4000)).norm(), 1e-12);
  EXPECT_LT((at(-1500) - Eigen::Vector3d(-1500, 0, 0)).norm(), 1e-12);
}

TEST(PiecewiseLinear, TheLengthsSumToTheValue) {
  for (const std::vector<double>& borders :
       {std::vector<double>{-10, 0, 5, 10}, {0, 5, 10}, {-10, -5, 0}, {0, 1}, {-3, -1, 0, 2}}) {
    PiecewiseLinear intervals;
    ASSERT_EQ(intervals.setBorders(borders), "");
    for (double value = -20.0; value <= 20.0; value += 0.5) {
      double sum = 0.0;
      for (int i = 0; i < intervals.intervals(); ++i) sum += intervals.length(i, value);
      EXPECT_DOUBLE_EQ(sum, value);
    }
  }
}

TEST(PiecewiseLinear, RefusesBordersThatAreNone) {
  PiecewiseLinear intervals;
  EXPECT_NE(intervals.setBorders({0}), "");
  EXPECT_NE(intervals.setBorders({0, 0}), "");
  EXPECT_NE(intervals.setBorders({1000, 0}), "");
  EXPECT_NE(intervals.setBorders({1, 2}), "");
  EXPECT_NE(intervals.setBorders({0, std::nan("")}), "");
}
