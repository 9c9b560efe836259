#pragma once

#include <Eigen/Core>
#include <string>

#include "ClosedCurves.h"

namespace mien {

/// The plane of a picture in orthogonal projection: right and up in the picture, and out of it towards the viewer, unit
/// vectors at right angles. The default is the front: x to the right, y up, z out.
struct PicturePlane {
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d out = Eigen::Vector3d::UnitZ();

  /// @param towardsViewer  from the surface to the viewer, any length but 0
  /// @param upwards        what is up in the picture, not along the view
  /// @return nothing, or one sentence that says what is wrong; the plane is then as it was
  std::string look(const Eigen::Vector3d& towardsViewer, const Eigen::Vector3d& upwards);

  Eigen::Vector2d project(const Eigen::Vector3d& p) const { return {p.dot(right), p.dot(up)}; }
  double depth(const Eigen::Vector3d& p) const { return p.dot(out); }  ///< larger: nearer to the viewer
};

}  // namespace mien
