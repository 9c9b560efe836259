#pragma once

#include "QuadraticMap.h"

namespace mien {

/// Points in the plane, one per row, in pupil units.
using PlanePoints = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// The quadratic map that takes points before to points after with the least sum of squares, and how well it does.
struct QuadraticFit {
  QuadraticMap map;
  int points = 0;
  int rank = 0;                      ///< independent points, at most 6
  double rms = 0.0;                  ///< distance left over, pupil units
  double largestDisplacement = 0.0;  ///< of the points themselves, pupil units

  /// Fewer than six independent points: the map leans on the affine fit.
  bool sparse() const { return rank < 6; }

  /// Fewer points than twice the coefficients: noise decides some of them.
  bool weak() const { return points < 12; }
};

/// Least squares by column-pivoting QR on centred and scaled points, never the normal equations. Fewer than six
/// independent points are fitted with a ridge towards their affine fit, and the affine fit of a set on a line is the
/// smallest change of place. Fewer than twelve points follow their own errors along directions they hardly determine,
/// and run away beside the points: when `noise` is known, these are fitted with a ridge of noise / 0.3 on all but the
/// shift (the most likely map when its coefficients have a deviation of 0.3 pupil units over the set's extent). Points
/// that fit exactly have no noise, and no ridge. Both sets have the same number of rows, at least one.
/// @param noise  standard deviation of a coordinate, pupil units
QuadraticFit fitQuadraticMap(const PlanePoints& before, const PlanePoints& after, double noise = 0.0);

}  // namespace mien
