#pragma once

#include <Eigen/Core>

namespace mien {

/// A uniform scale, a rotation and a shift: p -> scale rotation p + translation.
struct Similarity {
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

  double scale = 1.0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const { return scale * (rotation * p) + translation; }
  Points applied(const Points& points) const {
    return ((scale * points * rotation.transpose()).rowwise() + translation.transpose()).eval();
  }
  Similarity inverse() const {
    return {1.0 / scale, rotation.transpose(), -(rotation.transpose() * translation) / scale};
  }
};

/// The similarity, or with `rigid` the rigid motion, that takes `from` nearest to `to` by weighted least squares
/// [Umeyama 1991]; never a reflection.
Similarity fitSimilarity(const Similarity::Points& from, const Similarity::Points& to, const Eigen::VectorXd& weights,
                         bool rigid);

}  // namespace mien
