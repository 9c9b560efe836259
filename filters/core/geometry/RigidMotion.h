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

}  // namespace mien
