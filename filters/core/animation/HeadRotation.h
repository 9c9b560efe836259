#pragma once

#include <Eigen/Core>

#include "ClosedCurves.h"
#include "FAPFrame.h"

namespace mien {

/// The rotation of the head by FAPs 48 (pitch, positive: the face turns down), 49 (yaw, positive: to the subject's
/// left) and 50 (roll, positive: the top of the head tilts to the subject's right), each in 1e-5 rad (ISO/IEC 14496-2).
///
/// Roll is applied first, then pitch, then yaw, all about axes fixed in space: R = yaw pitch roll.
struct HeadRotation {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< 7.1, the top of the spine, mm

  HeadRotation() = default;
  HeadRotation(const FAPFrame& frame, const Eigen::Vector3d& centreOfRotation);

  bool turns() const;                              ///< false: the points stay bit for bit
  void apply(ClosedCurves::Points& points) const;  ///< from the head's own frame to space
  void undo(ClosedCurves::Points& points) const;   ///< back to the head's own frame
};

}  // namespace mien
