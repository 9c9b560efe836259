#pragma once

#include <cstdint>
#include <vector>

#include "ClosedCurves.h"

namespace mien {

/// The boundary curves of a face as whole numbers: multiples of one step that come near the curves' coefficients.
struct CurveLevels {
  double step = 0.0;                 ///< mm
  std::vector<std::int64_t> values;  ///< in the order of CurveCoder; zeros at the end are left out
};

/// Turns 29 boundary curves of K points into levels and back.
///
/// The chain of 28 curves, C22 and C22' replaced by their mean, goes through CurveTransform as a whole, half the
/// difference of the two lips by itself. Coefficients stand in the order in which they matter: those of a face
/// symmetric in x, the lips' among them, then those that are asymmetric, each by (1 + row)(1 + harmonic). So a
/// symmetric face with closed lips needs neither flags nor bytes for what it does not have.
class CurveCoder {
 public:
  static constexpr std::int64_t largestLevel = std::int64_t(1) << 40;  ///< either sign

  /// @param pointsPerCurve  K, even, at least 8
  explicit CurveCoder(int pointsPerCurve);

  int coefficientCount() const { return static_cast<int>(places_.size()); }  ///< 29 * K * 3

  /// In the order of levels, mm.
  Eigen::VectorXd coefficients(const ClosedCurves& curves) const;

  /// Up to 0.57 steps become 0, 0.57 to 1.57 steps become 1 and so on: a little less than the nearest level, which
  /// saves more bytes than it costs in error (doc/decisions.md).
  CurveLevels levels(const Eigen::VectorXd& coefficients, double step) const;

  /// The curves, in their order down the face; symmetric in x to the bit when no asymmetric level is set.
  ClosedCurves curves(const CurveLevels& levels) const;

 private:
  /// Where a coefficient stands in the matrices of the three coordinates.
  struct Place {
    int part, row, column, axis;
  };

  int pointsPerCurve_;
  std::vector<Place> places_;
};

}  // namespace mien
