#pragma once

#include <Eigen/Core>

namespace mien {

/// A point of a surface S(u, v) and its derivatives to the second order (mm, mm per u, mm per radian, ...).
///
/// At the border of a patch it is one-sided: the derivatives are those of that patch's own solution.
struct SurfaceJet {
  Eigen::Vector3d s = Eigen::Vector3d::Zero();
  Eigen::Vector3d su = Eigen::Vector3d::Zero();
  Eigen::Vector3d sv = Eigen::Vector3d::Zero();
  Eigen::Vector3d suu = Eigen::Vector3d::Zero();
  Eigen::Vector3d suv = Eigen::Vector3d::Zero();
  Eigen::Vector3d svv = Eigen::Vector3d::Zero();
};

}  // namespace mien
