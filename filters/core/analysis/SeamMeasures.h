#pragma once

#include "SurfaceJet.h"

namespace mien {

/// How far two surfaces are from continuing each other at one point of a seam u = constant.
///
/// An angle or curvature is NaN where one of the sides has no tangent plane.
struct SeamMeasures {
  double g0 = 0.0;  ///< gap between the two sides, mm
  double g1 = 0.0;  ///< angle between the unit normals, degrees, 0 .. 180
  double c1 = 0.0;  ///< |S_u- - S_u+| relative to the mean of |S_u-| and |S_u+|; 0 where both vanish
  double g2 = 0.0;  ///< difference of the normal curvatures perpendicular to the seam, 1/mm
  double c2 = 0.0;  ///< |S_uu- - S_uu+| relative to the mean of |S_uu-| and |S_uu+|; 0 where both vanish

  SeamMeasures() = default;

  /// @param before,after  the one-sided jets of the patch that ends in the seam and of the one that begins there
  SeamMeasures(const SurfaceJet& before, const SurfaceJet& after);
};

}  // namespace mien
