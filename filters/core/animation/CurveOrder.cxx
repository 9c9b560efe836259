#include "CurveOrder.h"

#include <algorithm>
#include <cmath>

#include "SoftDistance.h"

namespace mien {

CurveOrder::CurveOrder(const ClosedCurves& neutral, const std::vector<ContactPair>& contacts) : neutral_(neutral) {
  std::vector<ContactPair> sorted = contacts;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.upper < b.upper; });
  // Upwards first, then downwards: between two contacts the second sweep only takes what is short of room.
  for (size_t i = sorted.size(); i-- > 0;)
    sweeps_.push_back({sorted[i].upper, i == 0 ? 0 : sorted[i - 1].lower + 1, softShare});
  for (size_t i = 0; i < sorted.size(); ++i) {
    const bool last = i + 1 == sorted.size();
    sweeps_.push_back({sorted[i].lower, last ? neutral.count - 1 : sorted[i + 1].upper - 1, last ? softShare : 1e-3});
  }
}

void CurveOrder::push(ClosedCurves& curves, const Sweep& sweep) {
  const int k = curves.pointsPerCurve;
  const int step = sweep.to < sweep.from ? -1 : 1;
  for (int c = sweep.from; c != sweep.to; c += step)
    for (int j = 0; j < k; ++j) {
      const double pusher = curves.curve(c)(j, 1);
      double& pushed = curves.points(static_cast<Eigen::Index>(c + step) * k + j, 1);
      const double neutral = step * (neutral_.curve(c)(j, 1) - neutral_.curve(c + step)(j, 1));
      const double distance = step * (pusher - pushed);
      const double room = softDistance(distance, neutral, sweep.soft);
      if (room == distance) continue;
      pushed = pusher - step * room;
      pushed_ = std::max(pushed_, std::abs(room - distance));
    }
}

void CurveOrder::drawBack(ClosedCurves& curves) {
  const int k = curves.pointsPerCurve;
  for (Eigen::Index row = 0; row + k < curves.points.rows(); ++row) {
    const double distance = curves.points(row, 1) - curves.points(row + k, 1);
    const double neutral = neutral_.points(row, 1) - neutral_.points(row + k, 1);
    if (distance < std::min(neutral, 0.0) - 1e-9)
      keptShare_ = std::min(keptShare_, std::max(neutral, 0.0) / (std::max(neutral, 0.0) - distance));
  }
  if (keptShare_ < 1.0) curves.points = neutral_.points + keptShare_ * (curves.points - neutral_.points);
}

void CurveOrder::reset() {
  keptShare_ = 1.0;
  pushed_ = 0.0;
}

void CurveOrder::restore(ClosedCurves& curves) {
  reset();
  for (const Sweep& sweep : sweeps_) push(curves, sweep);
  drawBack(curves);
}

}  // namespace mien
