#pragma once

#include <Eigen/Core>
#include <string>

namespace mien {

/// Brings a face into pupil units: midpoint of the pupils to the origin, rotation about z and uniform scale so that the
/// subject's left pupil is at (1, 0) and the right at (-1, 0) [Obaid et al. 2009, section 3].
class PupilNormalisation {
 public:
  /// @return nothing, or one sentence that says why the pupils cannot serve
  std::string set(const Eigen::Vector3d& left, const Eigen::Vector3d& right);

  Eigen::Vector3d apply(const Eigen::Vector3d& point) const;
  Eigen::Vector3d invert(const Eigen::Vector3d& point) const;

  /// Length of one pupil unit in the face's own unit (mm, pixels): half the distance of the pupils as seen from the
  /// front.
  double unit() const { return unit_; }

 private:
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d axis_ = Eigen::Vector2d::UnitX();  ///< from the right pupil to the left
  double unit_ = 1.0;
};

}  // namespace mien
