#pragma once

#include <algorithm>

namespace mien {

/// 0 below 0, 1 above 1, 3 t^2 - 2 t^3 between: continuous with its slope.
inline double smoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace mien
