#include <gtest/gtest.h>

#include <limits>

#include "SameCurves.h"

using namespace mien;

TEST(SameCurves, DifferByRoundingAtMost) {
  ClosedCurves curves(2, 8);
  curves.points = 120.0 * ClosedCurves::Points::Random(curves.points.rows(), 3);
  ClosedCurves single = curves, moved = curves, unknown = curves;
  single.points = curves.points.cast<float>().cast<double>();
  moved.points(5, 1) += 0.01;
  unknown.points(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(areSameCurves(curves, curves));
  EXPECT_TRUE(areSameCurves(curves, single));
  EXPECT_FALSE(areSameCurves(curves, moved));
  EXPECT_FALSE(areSameCurves(unknown, unknown)) << "what is not known is the same as nothing";
  EXPECT_FALSE(areSameCurves(curves, ClosedCurves(2, 10)));
  EXPECT_FALSE(areSameCurves(curves, ClosedCurves(3, 8)));
}
