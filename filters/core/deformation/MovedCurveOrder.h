#pragma once

#include "ClosedCurves.h"

namespace mien {

/// What it took to put moved curves in order.
struct MovedCurveOrder {
  double pushed = 0.0;     ///< the furthest that a sample gave way along y, mm
  double keptShare = 1.0;  ///< of the whole movement, where giving way was not enough
  int crossings = 0;       ///< between samples, that are left (countCrossings)

  MovedCurveOrder() = default;

  /// Puts the samples of curves that a table moved in order down the face, as files of curves must be: lips and lids
  /// that crossed meet halfway, and curves beside them make room as under FAPs (CurveOrder.h). Curves in order stay bit
  /// for bit.
  MovedCurveOrder(const ClosedCurves& neutral, ClosedCurves& moved);
};

}  // namespace mien
