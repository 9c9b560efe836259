#include "ContourSight.h"

namespace mien {

namespace {

constexpr double sliverWidth = 8.0;   // mm
constexpr double edgeRise = 15.0;     // mm, in the first step: a ball of 20 cm rises by 10 mm there
constexpr double rise = 6.0;          // mm, in any other: the same ball rises by 4 mm
constexpr double doubledWidth = 2.0;  // mm
constexpr double step = 0.25;         // mm

/// In the picture; 0 where the direction points at the viewer.
Eigen::Vector2d directionIn(const PicturePlane& plane, const Eigen::Vector3d& inward) {
  return Eigen::Vector2d(inward.dot(plane.right), inward.dot(plane.up)).stableNormalized();
}

}  // namespace

bool ContourSight::isSliver(const Eigen::Vector3d& point, const Eigen::Vector3d& inward) const {
  const Eigen::Vector2d at = plane_.project(point), along = directionIn(plane_, inward);
  double last = plane_.depth(point), most = edgeRise;
  for (double away = step; away <= sliverWidth && !along.isZero(); away += step) {
    const auto front = surface_.frontDepth(at + away * along);
    if (!front) return false;
    if (*front > last + most) return true;
    last = *front;
    most = rise;
  }
  return false;
}

bool ContourSight::isDoubled(const Eigen::Vector3d& point, const Eigen::Vector3d& inward) const {
  const Eigen::Vector2d at = plane_.project(point), along = directionIn(plane_, inward);
  const auto outside = surface_.frontDepth(at - step * along);
  if (along.isZero() || !outside || *outside < plane_.depth(point) - edgeRise) return false;
  for (double away = 2.0 * step; away <= doubledWidth; away += step)
    if (!surface_.frontDepth(at - away * along)) return true;
  return false;
}

}  // namespace mien
