#pragma once

#include "FaceCurves.h"

namespace mien {

/// Where the mouth can open: v of its right and left corner (radians, begin < end).
struct MouthCorners {
  double begin = 0.0, end = 0.0;

  MouthCorners() = default;
  /// From the ends of the inner lip contour (features 2.4 and 2.5); without them from the samples where the lips are
  /// apart. Both 0 when the mouth is closed and has no corners.
  explicit MouthCorners(const FaceCurves& face);

  bool contain(double v) const { return v > begin && v < end; }
};

}  // namespace mien
