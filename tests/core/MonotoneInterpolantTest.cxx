#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "MonotoneInterpolant.h"

using mien::MonotoneInterpolant;

TEST(MonotoneInterpolant, MeetsItsKnotsInAnyOrder) {
  const MonotoneInterpolant f({{3.0, 1.0}, {0.0, 2.0}, {1.0, -5.0}});
  EXPECT_DOUBLE_EQ(f(0.0), 2.0);
  EXPECT_DOUBLE_EQ(f(1.0), -5.0);
  EXPECT_DOUBLE_EQ(f(3.0), 1.0);
}

TEST(MonotoneInterpolant, NeverLeavesTheRangeOfItsNeighbours) {
  const std::vector<std::pair<double, double>> knots = {{0, 0},    {1, 10}, {1.5, 10.5}, {4, 11},
                                                        {4.2, -3}, {6, -3}, {9, 0}};
  const MonotoneInterpolant f(knots);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int k = 0; k <= 100; ++k) {
      const double y = f(knots[i].first + 0.01 * k * (knots[i + 1].first - knots[i].first));
      EXPECT_GE(y, std::min(knots[i].second, knots[i + 1].second) - 1e-12);
      EXPECT_LE(y, std::max(knots[i].second, knots[i + 1].second) + 1e-12);
    }
}

TEST(MonotoneInterpolant, HasAContinuousSlope) {
  const MonotoneInterpolant f({{0, 0}, {1, 10}, {1.5, 11}, {4, 20}});
  const double h = 1e-6;
  for (const double knot : {1.0, 1.5})
    EXPECT_NEAR((f(knot + h) - f(knot)) / h, (f(knot) - f(knot - h)) / h, 1e-3) << "at " << knot;
}

TEST(MonotoneInterpolant, IsConstantBeyondItsEndsAndAveragesRepeatedKnots) {
  const MonotoneInterpolant f({{1.0, 2.0}, {1.0, 4.0}, {2.0, 7.0}});
  EXPECT_DOUBLE_EQ(f(-10.0), 3.0);
  EXPECT_DOUBLE_EQ(f(10.0), 7.0);
}
