#pragma once

#include <functional>

#include "ClosedCurves.h"
#include "PlaneDrawing.h"

namespace mien {

/// Boundary curves as line drawings in the plane of the front view: x right as seen (the subject's left), y up, mm.
class CurveDrawing {
 public:
  /// @param from, to  range of v that is drawn, radians; the frontal half by default
  explicit CurveDrawing(const ClosedCurves& curves, double from = 0.5 * M_PI, double to = 1.5 * M_PI);

  /// The curve as its trigonometric interpolant.
  QPolygonF line(int curve) const;

  /// Its samples within the range.
  QPolygonF samples(int curve) const;

  /// Adds every curve for which `stroke` gives a line of some width.
  void addLines(PlaneDrawing& drawing, const std::function<PlaneStroke(int curve)>& stroke) const;

  /// Adds the names of the curves beside their ends, one below the other, with leaders.
  ///
  /// @param right  at the end of larger v, on the right of the picture; else on the left
  /// @param gap    least distance of two names, mm of the face
  void addNames(PlaneDrawing& drawing, const std::vector<int>& curves, bool right, double gap) const;

  /// Adds a bracket and a name for each of the nine patches on the left, from its first curve to its last.
  ///
  /// @param distance  of the brackets from the curves, mm of the face
  void addPatchNames(PlaneDrawing& drawing, double distance) const;

  QRectF bounds() const;

 private:
  const ClosedCurves& curves_;
  double from_, to_;
};

}  // namespace mien
