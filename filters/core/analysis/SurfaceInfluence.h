#pragma once

#include <vector>

#include "BoundaryCoefficients.h"
#include "FaceSurface.h"

namespace mien {

/// What moves by one unit: a whole curve, or one sample of it (its trigonometric interpolant follows).
struct InfluenceSource {
  static constexpr int wholeCurve = -1;

  int curve = 0;           ///< 0 .. 28
  int point = wholeCurve;  ///< sample, 0 .. K - 1
};

/// The move of the surface per unit move of the source, the same number for x, y and z since S = U B is linear
/// [S 3.1]: (rows of the layout x columns), no unit. Empty when the scheme's conditions determine no surface.
RowMajor<double> surfaceInfluence(const FaceSurfaceOptions& options, int pointsPerCurve, const RowLayout& layout,
                                  int columns, const InfluenceSource& source);

/// How an influence fades along u, and how far from its curve it has fallen to half.
struct InfluenceProfile {
  std::vector<double>
      position;  ///< of each row, counted in curves down the face: 0 at C1, 27 at C28, the lips at one place
  std::vector<double> largest;  ///< the largest absolute influence in each row

  /// On the side towards C1 and towards C28; NaN where the influence stays above half of its value at the curve.
  double curvesAbove, curvesBelow;
  double rowsAbove, rowsBelow;

  InfluenceProfile(const RowMajor<double>& influence, const RowLayout& layout, int curve);
};

}  // namespace mien
