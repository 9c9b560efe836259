#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "FaceCurves.h"

namespace mien {

/// A dark sack behind the lips, so that nobody looks through an open mouth out of the back of a face that has neither
/// teeth nor tongue: a cone from the inner contours of the lips to a point inside the head.
struct MouthInside {
  static constexpr double depth = 30.0;    ///< mm, of the cone's point behind the lips
  static constexpr double retreat = 0.6;   ///< mm, of its edge behind the lips, which hide it
  static constexpr double overlap = 1.5;   ///< mm, of its edge beyond the lips, which are round between samples
  static constexpr double leastGap = 0.4;  ///< mm between the lips; a mouth that is less open has no inside

  std::vector<Eigen::Vector3d> points;        ///< mm
  std::vector<std::array<int, 3>> triangles;  ///< of points; empty for a closed mouth
  double gap = 0.0;                           ///< mm between the lips where they are furthest apart

  explicit MouthInside(const FaceCurves& face);
};

}  // namespace mien
