#pragma once

#include <Eigen/Core>
#include <cmath>

namespace mien {

/// The vertical line through the head from which it is measured: cylinder coordinates (azimuth, y, radius).
///
/// The azimuth is 0 towards the nose (+z) and grows towards the subject's left (+x), in radians.
struct HeadAxis {
  double x = 0.0;  ///< mm
  double z = 0.0;  ///< mm

  double azimuth(const Eigen::Vector3d& p) const { return std::atan2(p.x() - x, p.z() - z); }
  double radius(const Eigen::Vector3d& p) const { return std::hypot(p.x() - x, p.z() - z); }
  Eigen::Vector3d point(double azimuth, double y, double radius) const {
    return {x + radius * std::sin(azimuth), y, z + radius * std::cos(azimuth)};
  }
};

}  // namespace mien
