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
};

/// Least squares by column-pivoting QR on centred and scaled points, never the normal equations. A sparse set is
/// fitted with a ridge towards its affine fit, and the affine fit of a set on a line is the smallest change of place.
/// Both sets have the same number of rows, at least one.
QuadraticFit fitQuadraticMap(const PlanePoints& before, const PlanePoints& after);

}  // namespace mien
