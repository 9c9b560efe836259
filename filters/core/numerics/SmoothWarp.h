#pragma once

#include <Eigen/Core>

namespace mien {

/// The smoothest map of the plane or of space that takes given points to given places: an affine map and radial
/// functions, r^2 log r in the plane and r in space [Duchon 1977; Bookstein 1989, thin-plate splines]. Affine maps are
/// reproduced exactly.
class SmoothWarp {
 public:
  using Points = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param from,to  one point per row, 2 or 3 columns; points of `from` differ and do not lie in one line (plane)
  /// @param softness  0: every point is met; above, smoothness counts more, in units of the points' mean squared
  ///                  distance (in the plane) or mean distance (in space)
  SmoothWarp(const Points& from, const Points& to, double softness = 0.0);

  /// Whether the equations determine a finite map.
  bool sound() const { return sound_; }

  Eigen::VectorXd operator()(const Eigen::VectorXd& place) const;

  /// The derivative, rows: components of the image, columns: of the place.
  Eigen::MatrixXd derivative(const Eigen::VectorXd& place) const;

 private:
  double radial(double r) const;

  Points from_;     ///< centred and scaled
  Points weights_;  ///< one row per point, then 1 and the coordinates
  Eigen::VectorXd middle_;
  double scale_ = 1.0;
  bool sound_ = false;
};

}  // namespace mien
