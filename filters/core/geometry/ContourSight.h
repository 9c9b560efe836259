#pragma once

#include "SurfaceOcclusion.h"

namespace mien {

/// Says which parts of a contour that is seen are no part of one clean line around what is in front.
class ContourSight {
 public:
  /// Both must live as long as this.
  ContourSight(const SurfaceOcclusion& surface, const PicturePlane& plane) : surface_(surface), plane_(plane) {}

  /// Whether the point is the edge of a sliver: beside it, nearer than 8 mm, something else begins in front, as the jaw
  /// before the neck.
  /// @param inward  in which direction what is seen lies beside the point
  bool isSliver(const Eigen::Vector3d& point, const Eigen::Vector3d& inward) const;

  /// Whether the point lies less than 2 mm within the outline of all, and of what is no sliver: it stands for both.
  bool isDoubled(const Eigen::Vector3d& point, const Eigen::Vector3d& inward) const;

 private:
  const SurfaceOcclusion& surface_;
  const PicturePlane& plane_;
};

}  // namespace mien
