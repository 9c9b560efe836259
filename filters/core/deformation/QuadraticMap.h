#pragma once

#include <Eigen/Core>
#include <string>

namespace mien {

/// x' = a1 x^2 + a2 xy + a3 y^2 + a4 x + a5 y + a6, y' the same with b1 .. b6 [Obaid et al. 2009, eq. 1], in pupil
/// units.
struct QuadraticMap {
  using Coefficients = Eigen::Matrix<double, 2, 6, Eigen::RowMajor>;
  using Basis = Eigen::Matrix<double, 6, 1>;

  Coefficients coefficients = identity();  ///< row 0: a1 .. a6, row 1: b1 .. b6

  static Coefficients identity();

  /// (x^2, xy, y^2, x, y, 1)
  static Basis basis(const Eigen::Vector2d& point);

  Eigen::Vector2d apply(const Eigen::Vector2d& point) const { return coefficients * basis(point); }
  Eigen::Matrix2d jacobian(const Eigen::Vector2d& point) const;

  /// The map of the mirrored face: (-a1, a2, -a3, a4, -a5, -a6; b1, -b2, b3, -b4, b5, b6).
  QuadraticMap mirrored() const;
};

/// a1 .. a6, b1 .. b6 for 0 .. 11.
std::string coefficientName(int index);

}  // namespace mien
