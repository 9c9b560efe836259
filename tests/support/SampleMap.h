#pragma once

#include "QuadraticMap.h"

/// A map with twelve different coefficients.
inline mien::QuadraticMap sampleMap() {
  mien::QuadraticMap map;
  map.coefficients << 0.3, -0.2, 0.1, 1.2, 0.05, -0.3, -0.15, 0.25, 0.4, -0.1, 0.9, 0.2;
  return map;
}
