#pragma once

#include <Eigen/Core>

#include "ClosedCurves.h"

namespace mien {

/// A rotation and a shift: p -> rotation p + translation (mm).
struct RigidMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  /// The points before the motion.
  ClosedCurves::Points undone(const ClosedCurves::Points& moved) const;

  double angle() const;  ///< radians, 0 .. pi
};

/// The rigid motion that takes `from` nearest to `to` in the sense of least squares [Kabsch 1976]; never a
/// reflection. Both have the same rows; without rows the result moves nothing.
RigidMotion fitRigidMotion(const ClosedCurves::Points& from, const ClosedCurves::Points& to);

/// The rigid motion of the part of a surface that keeps its shape, whatever the rest does: iteratively reweighted least
/// squares with the weights of Geman and McClure [1985], 1 / (1 + (r / s)^2)^2 for a distance r. The scale s is in each
/// round the distance that a quarter of the points keep, so that it shrinks to the noise of the stillest quarter. It is
/// begun from no motion and from fitRigidMotion(); the result whose stillest quarter is nearer is taken, no motion
/// first. Nothing is random.
RigidMotion fitStillPart(const ClosedCurves::Points& from, const ClosedCurves::Points& to);

}  // namespace mien
