#include "SideOrder.h"

#include <algorithm>
#include <cmath>

#include "SoftDistance.h"

namespace mien {

namespace {

constexpr double softShareBack = 1e-9;

/// How many samples from the middle outwards lie ever further from the middle of the face.
int ascending(const ClosedCurves& neutral, int curve, int step) {
  const int middle = neutral.pointsPerCurve / 2;
  int count = 1;
  while (count < middle && step * (neutral.curve(curve)(middle + count * step, 0) -
                                   neutral.curve(curve)(middle + (count - 1) * step, 0)) >
                               0.0)
    ++count;
  return count;
}

}  // namespace

SideOrder::SideOrder(const ClosedCurves& neutral, const std::vector<CurveBand>& bands) : neutral_(neutral) {
  for (const CurveBand& band : bands)
    for (int curve = band.first; curve <= band.last; ++curve)
      for (int step : {1, -1}) sides_.push_back({curve, step, ascending(neutral, curve, step)});
}

/// Every sample pushes the next in `direction`, 1 outwards or -1 inwards; the middle one, which both sides share, is
/// never pushed.
void SideOrder::push(ClosedCurves& curves, const Side& side, int from, int direction, double soft) {
  const int k = curves.pointsPerCurve;
  const int outwards = side.step * direction;
  for (int i = from, next = from + direction; next > 0 && next < side.count; i = next, next += direction) {
    const int a = k / 2 + i * side.step, b = k / 2 + next * side.step;
    double& pushed = curves.points(static_cast<Eigen::Index>(side.curve) * k + b, 0);
    const double pusher = curves.curve(side.curve)(a, 0);
    const double neutral = outwards * (neutral_.curve(side.curve)(b, 0) - neutral_.curve(side.curve)(a, 0));
    const double distance = outwards * (pushed - pusher);
    const double room = softDistance(distance, neutral, soft);
    if (room == distance) continue;
    pushed = pusher + outwards * room;
    pushed_ = std::max(pushed_, std::abs(room - distance));
  }
}

void SideOrder::restore(ClosedCurves& curves) {
  reset();
  for (const Side& side : sides_) {
    push(curves, side, 0, 1, softShare);
    const int widest = curves.pointsPerCurve / 2 + (side.count - 1) * side.step;
    curves.points(static_cast<Eigen::Index>(side.curve) * curves.pointsPerCurve + widest, 0) =
        neutral_.curve(side.curve)(widest, 0);
    push(curves, side, side.count - 1, -1, softShareBack);
  }
}

}  // namespace mien
