#include "PicturePlane.h"

#include <Eigen/Geometry>

namespace mien {

std::string PicturePlane::look(const Eigen::Vector3d& towardsViewer, const Eigen::Vector3d& upwards) {
  const Eigen::Vector3d direction = towardsViewer.normalized(), across = upwards.cross(direction);
  if (!(direction.norm() > 0.5) || !(across.norm() > 1e-9 * upwards.norm()))
    return "the view direction is 0 or the view up lies along it; give two different directions";
  out = direction;
  right = across.normalized();
  up = out.cross(right);
  return {};
}

}  // namespace mien
