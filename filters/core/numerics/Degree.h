#pragma once

#include <cmath>

namespace mien {

constexpr double degree = M_PI / 180.0;  ///< in radians

}  // namespace mien
