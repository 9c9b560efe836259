#include <gtest/gtest.h>

#include <cmath>

#include "FaceCurves.h"
#include "FaceLayout.h"
#include "MovedCurveOrder.h"

using namespace mien;

namespace {

/// 29 rings 4 mm apart, the lips touching.
ClosedCurves rings() {
  ClosedCurves curves(FaceLayout::curveCount, 40);
  for (int c = 0; c < curves.count; ++c)
    for (int j = 0; j < 40; ++j) {
      const double v = 2.0 * M_PI * j / 40, row = c - (c >= FaceLayout::lowerLip);
      curves.curve(c).row(j) << 60.0 * std::cos(v), -4.0 * row, 60.0 * std::sin(v);
    }
  return curves;
}

/// One curve bulges by `up` mm where it looks to the front.
void bulge(ClosedCurves& curves, int curve, double up) {
  for (int j = 0; j < 40; ++j) curves.curve(curve)(j, 1) += up * std::exp(-std::pow((j - 10) / 3.0, 2));
}

bool isInOrder(const ClosedCurves& curves) {
  for (int c = 0; c + 1 < curves.count; ++c)
    if ((curves.curve(c).col(1) - curves.curve(c + 1).col(1)).minCoeff() < 0.0) return false;
  return true;
}

}  // namespace

TEST(MovedCurveOrder, CurvesInOrderStayBitForBit) {
  const ClosedCurves neutral = rings();
  ClosedCurves moved = neutral;
  bulge(moved, 15, 3.0);
  const ClosedCurves::Points before = moved.points;
  const MovedCurveOrder order(neutral, moved);
  EXPECT_EQ(moved.points, before);
  EXPECT_EQ(order.pushed, 0.0);
  EXPECT_EQ(order.keptShare, 1.0);
}

TEST(MovedCurveOrder, CrossedCurvesAreCrossedNoMoreAndMoveAlongYAlone) {
  const ClosedCurves neutral = rings();
  for (const auto& [curve, up] : {std::pair(15, 9.0), std::pair(FaceLayout::lowerLip, 3.0), std::pair(9, 5.0),
                                  std::pair(FaceLayout::upperLip, -2.0), std::pair(3, -11.0)}) {
    ClosedCurves moved = neutral;
    bulge(moved, curve, up);
    ASSERT_GT(countCrossings(moved), 0);
    const ClosedCurves given = moved;
    const MovedCurveOrder order(neutral, moved);
    EXPECT_TRUE(isInOrder(moved)) << curve;
    EXPECT_EQ(order.crossings, countCrossings(moved));
    EXPECT_GT(order.pushed, 0.0);
    EXPECT_EQ(order.keptShare, 1.0);
    EXPECT_EQ(moved.points.col(0), given.points.col(0));
    EXPECT_EQ(moved.points.col(2), given.points.col(2));
    EXPECT_LE(order.pushed, 2.0 * std::abs(up));
    // The back of the head has nothing to do with it.
    EXPECT_EQ(moved.curve(curve).row(30), given.curve(curve).row(30));
  }
}

TEST(MovedCurveOrder, AbsurdMovementIsDrawnBack) {
  const ClosedCurves neutral = rings();
  ClosedCurves moved = neutral;
  for (int j = 0; j < 40; ++j) moved.curve(20)(j, 1) += j % 2 ? 40.0 : -40.0;
  const MovedCurveOrder order(neutral, moved);
  EXPECT_TRUE(isInOrder(moved));
}
