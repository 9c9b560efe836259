#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace mien {

/// Closed curves sampled at v_j = 2 pi j / K, all with the same K.
///
/// `points` has one row per sample (curve after curve, K rows each) and the columns x, y, z in mm.
/// The closing sample is not stored. Between samples a curve is its trigonometric interpolant.
struct ClosedCurves {
  using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

  static constexpr double largestCoordinate = 1e15;  ///< products of larger ones leave single precision

  int count = 0;           ///< number of curves
  int pointsPerCurve = 0;  ///< K, even
  Points points;           ///< (count * K) x 3

  ClosedCurves() = default;
  ClosedCurves(int curveCount, int samplesPerCurve);

  /// The K x 3 block of one curve, in place.
  auto curve(int index) { return points.middleRows(index * pointsPerCurve, pointsPerCurve); }
  auto curve(int index) const { return points.middleRows(index * pointsPerCurve, pointsPerCurve); }

  /// The point at parameter v (radians, any value) of the trigonometric interpolant of one curve.
  Eigen::Vector3d at(int curveIndex, double v) const;
};

/// Values at v of the K trigonometric cardinal functions of K equidistant samples (K even): the
/// interpolant of samples f is weights.dot(f).
Eigen::VectorXd cardinalWeights(int pointsPerCurve, double v);

/// One sentence about the first point that is not finite or past largestCoordinate, or nothing.
/// @param nameOfCurve  by index from 0
std::string describePointFault(const ClosedCurves& curves, const std::function<std::string(int)>& nameOfCurve);

/// One sentence that says which curve is unusable and why, or nothing when all are finite, K is even
/// and K >= `minimumPoints`.
std::string describeFault(const ClosedCurves& curves, int minimumPoints = 8);

}  // namespace mien
