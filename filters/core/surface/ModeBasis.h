#pragma once

#include <Eigen/Core>

namespace mien {

/// Extended precision for the few small matrices on which everything else depends.
using Extended = long double;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedRow = Eigen::Matrix<Extended, 1, Eigen::Dynamic>;

/// The 2m solutions of (d2/du2 - rate^2)^m y = 0 on 0 <= u <= 1 [S eq. 5-8].
///
/// Large rates use decaying exponentials from both ends. There that basis is well conditioned; below
/// `largestSeriesRate` it is nearly dependent, and the solutions with y^(i)(1/2) = delta_ij are summed
/// as power series instead. doc/decisions.md has the figures.
class ModeBasis {
 public:
  static constexpr double largestSeriesRate = 5.0;

  /// @param rate   a n >= 0, per unit of u
  /// @param order  2m, even
  ModeBasis(double rate, int order);

  int order() const { return 2 * half_; }

  /// The derivative of that order of every solution at u.
  ExtendedRow row(Extended u, int derivative) const;

 private:
  void fillSeries();
  ExtendedRow seriesRow(Extended u, int derivative) const;
  ExtendedRow exponentialRow(Extended u, int derivative) const;

  Extended rate_;
  int half_;               ///< m
  ExtendedMatrix series_;  ///< (i, j): y_j^(i)(1/2); empty for exponentials
};

}  // namespace mien
