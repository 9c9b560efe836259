#pragma once

#include <Eigen/Core>

namespace mien {

/// The affine map of the plane that takes points to others with the least sum of squared distances.
class AffineFit {
 public:
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

  /// @param from,to  one point per row, as many of one as of the other
  AffineFit(const Points& from, const Points& to);

  /// Whether the points determine it: at least three that do not lie in one line.
  bool sound() const { return sound_; }

  Eigen::Vector2d operator()(const Eigen::Vector2d& place) const { return linear_ * place + shift_; }

  /// The square root of the area that a square of side 1 is taken to.
  double scale() const;

 private:
  Eigen::Matrix2d linear_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d shift_ = Eigen::Vector2d::Zero();
  bool sound_ = false;
};

}  // namespace mien
