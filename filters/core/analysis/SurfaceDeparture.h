#pragma once

#include "FaceSample.h"

namespace mien {

/// How far the points of a face lie from those with the same (u, v) of another (mm).
struct SurfaceDeparture {
  double rms = 0.0;  ///< weighted with the other's area
  double maximum = 0.0;

  /// @param reference  sampled at the same rows and columns
  SurfaceDeparture(const FaceSample& sample, const FaceSample& reference);
};

}  // namespace mien
