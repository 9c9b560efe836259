#include "PupilNormalisation.h"

namespace mien {

std::string PupilNormalisation::set(const Eigen::Vector3d& left, const Eigen::Vector3d& right) {
  if (!left.allFinite() || !right.allFinite()) return "a pupil's position is not finite; give both pupils";
  const Eigen::Vector2d axis = (left - right).head<2>();
  const double size = left.head<2>().norm() + right.head<2>().norm();
  // Closer than rounding of the coordinates allows, the direction between them is noise.
  if (axis.norm() <= 1e-9 * size || axis.norm() == 0.0) return "the pupils coincide; give two different positions";
  origin_ = 0.5 * (left + right);
  unit_ = 0.5 * axis.norm();
  axis_ = axis.normalized();
  return {};
}

Eigen::Vector3d PupilNormalisation::apply(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d d = (point - origin_) / unit_;
  return {axis_.x() * d.x() + axis_.y() * d.y(), axis_.x() * d.y() - axis_.y() * d.x(), d.z()};
}

Eigen::Vector3d PupilNormalisation::invert(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d d(axis_.x() * p.x() - axis_.y() * p.y(), axis_.y() * p.x() + axis_.x() * p.y(), p.z());
  return origin_ + unit_ * d;
}

}  // namespace mien
