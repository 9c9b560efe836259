#include "FacePosture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {

namespace {

// Pupil units. Noses of 20 heads come forward by 0.64 to 0.96 further than foreheads.
constexpr double halfWidth = 0.6, nearest = 0.4, highest = 1.6, clear = 0.3;

}  // namespace

bool standsOnItsHead(const std::vector<DeformationPoint>& points, const PupilNormalisation& pupils) {
  const double none = std::numeric_limits<double>::lowest();
  double above = none, below = none;
  for (const DeformationPoint& point : points) {
    const Eigen::Vector3d place = pupils.apply(point.position);
    const double height = std::abs(place.y());
    if (std::abs(place.x()) > halfWidth || height < nearest || height > highest) continue;
    double& front = place.y() > 0.0 ? above : below;
    front = std::max(front, place.z());
  }
  return below != none && above > below + clear;
}

}  // namespace mien
