#pragma once

#include <algorithm>

namespace mien {

/// A distance between neighbours that may shrink but not turn over: g becomes f^2 / (2f - g) below f, the share
/// `soft` of the neutral distance; smooth and positive for any g. Neighbours that touch from the start stay as they
/// are.
inline double softDistance(double distance, double neutral, double soft) {
  const double least = soft * std::max(neutral, 0.0);
  if (distance >= least || distance >= neutral) return distance;
  return least > 0.0 ? least * least / (2.0 * least - distance) : std::min(neutral, 0.0);
}

}  // namespace mien
