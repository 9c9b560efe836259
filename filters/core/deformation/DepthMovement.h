#pragma once

#include <array>
#include <vector>

#include "TableDeformation.h"

namespace mien {

/// A face's points, in its own unit, and how they are normalised.
struct NormalisedPoints {
  const std::vector<DeformationPoint>& points;
  const PupilNormalisation& pupils;
};

/// Root mean square of the movement in depth (z) of points that tables are fitted to, pupil units: what no table
/// carries.
struct DepthMovement {
  std::array<double, FacialRegions::count> regions{};  ///< of each; 0 without points
  double all = 0.0;

  /// @param before, after  as many points in the same order
  DepthMovement(const NormalisedPoints& before, const NormalisedPoints& after, const FacialRegions& map);
};

}  // namespace mien
