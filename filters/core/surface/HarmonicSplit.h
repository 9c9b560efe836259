#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace mien {

/// How closed curves of K samples are split in v: Fourier modes 0 .. N, and all that is above them as
/// one remainder [S eq. 9-11].
///
/// A curve has the real Fourier coefficients a_0, a_1, b_1, ..., a_{K/2}, K of them in this order.
class HarmonicSplit {
 public:
  /// @param pointsPerCurve  K, even
  /// @param modes           N, 0 .. K / 2
  HarmonicSplit(int pointsPerCurve, int modes, bool remainder);

  int pointsPerCurve() const { return pointsPerCurve_; }
  int modes() const { return modes_; }

  /// Parts of the split: N + 1 modes, and the remainder where there is one.
  int count() const { return modes_ + 1 + (remainder_ ? 1 : 0); }

  /// The rate of part j at smoothing parameter a: a n for a mode, a (N + 1) for the remainder.
  double rate(int part, double smoothing) const { return smoothing * part; }

  /// First of the Fourier coefficients of part j, and how many there are (0 for the remainder at N = K / 2).
  int firstCoefficient(int part) const { return part == 0 ? 0 : std::min(2 * part - 1, pointsPerCurve_); }
  int coefficientCount(int part) const;

  /// K x K: Fourier coefficients = analysis() * samples.
  Eigen::MatrixXd analysis() const;

  /// n x K: values (or derivatives with respect to v) at the n parameters v = synthesis() * coefficients.
  Eigen::MatrixXd synthesis(const Eigen::VectorXd& v, int derivative) const;

 private:
  int pointsPerCurve_;
  int modes_;
  bool remainder_;
};

}  // namespace mien
