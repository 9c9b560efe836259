#pragma once

#include <Eigen/Core>

namespace mien {

/// One coordinate of a stack of closed curves as coefficients: Fourier around each curve, then a cosine transform
/// (DCT-II) along the curves [S 7, and the JPEG transform, Ahmed et al. 1974].
///
/// Both are orthonormal, so that an error in the coefficients is the same error in the points (Parseval). Columns are
/// a_0, a_1, b_1, .., a_{K/2} as in HarmonicSplit, row 0 is the mean of the curves.
class CurveTransform {
 public:
  /// @param curves          at least 1
  /// @param pointsPerCurve  K, even, at least 2
  CurveTransform(int curves, int pointsPerCurve);

  Eigen::MatrixXd forward(const Eigen::MatrixXd& values) const;        ///< curves x K to coefficients
  Eigen::MatrixXd inverse(const Eigen::MatrixXd& coefficients) const;  ///< and back

 private:
  int pointsPerCurve_;
  Eigen::MatrixXd cosines_;  ///< curves x curves, orthogonal
};

}  // namespace mien
