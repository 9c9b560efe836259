#pragma once

#include "ClosedCurves.h"

namespace mien {

/// What it took to put moved curves in order.
struct MovedCurveOrder {
  double pushed = 0.0;     ///< the furthest that a sample gave way along y, mm
  double keptShare = 1.0;  ///< of the whole movement, where giving way was not enough

  MovedCurveOrder() = default;

  /// Puts curves that a table moved in order down the face: lips and lids that crossed meet halfway, curves beside
  /// them make room (CurveOrder.h), and what still crosses between samples draws the whole movement back just far
  /// enough. Curves in order stay bit for bit, and those of a neutral face that crosses itself as they are.
  MovedCurveOrder(const ClosedCurves& neutral, ClosedCurves& moved);
};

}  // namespace mien
