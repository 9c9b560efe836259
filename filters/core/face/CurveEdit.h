#pragma once

#include <string>
#include <vector>

#include "FaceCurves.h"

namespace mien {

/// A point of a curve moved by hand; its neighbourhood follows with a smooth fall-off.
///
/// A sample at distance s (radians of v) and t (curves) moves by `move` cos^2(pi s / (2 width)) cos^2(pi t / (2 spread
/// + 2)), and not at all from s = width and t = spread + 1 on. C22 and C22' count as one curve where the lips are
/// closed, so that they stay closed. The pupils follow the lids (C9, C10).
struct CurveEdit {
  static constexpr double largestMove = 100.0;  ///< mm
  static constexpr int largestSpread = 28;

  int curve = 0;                                   ///< 0 .. 28
  double v = 0.0;                                  ///< radians, 0 .. 2 pi
  Eigen::Vector3d move = Eigen::Vector3d::Zero();  ///< mm
  double width = 25.0 * M_PI / 180.0;              ///< radians of v, two samples .. pi
  int spread = 1;                                  ///< neighbouring curves that follow on either side, 0 .. 28
  bool mirrored = false;  ///< whether the other side moves as the mirror image; the point itself still rises by `move`

  /// An edit of sample `point` of curves of K samples, which does not move it yet.
  static CurveEdit ofPoint(int curve, int point, int pointsPerCurve);

  double vDegrees() const;
  double widthDegrees() const;
  void setWidthDegrees(double degrees);

  bool operator==(const CurveEdit& other) const;
  bool operator!=(const CurveEdit& other) const { return !(*this == other); }
};

/// One sentence that says which value of an edit is out of range for curves of K points and what is allowed, or
/// nothing.
std::string describeFault(const CurveEdit& edit, int pointsPerCurve);

/// Edits a face, one edit after the other.
/// @return nothing, or one sentence that names the edit and what is wrong with it, such as the curves that it would
/// make cross; the face is then left alone
std::string applyEdits(const std::vector<CurveEdit>& edits, FaceCurves& face);

}  // namespace mien
