#pragma once

#include <functional>

#include "FaceCurves.h"
#include "FaceSurface.h"
#include "SweepBreakdown.h"

namespace mien {

/// Finds the a where a scheme breaks down between the values of a sweep: by bisection, on one grid after the other,
/// each with twice the rows and columns, until a stays.
class BreakdownSearch {
 public:
  static constexpr double tolerance = 0.01;       ///< relative, of a: of a bisection, and between two grids
  static constexpr int rows = 112, columns = 80;  ///< of the first grid
  static constexpr int mostRows = 448;            ///< of the last one

  /// @param surface  all but scheme and smoothing
  /// @param least    the smallest a that counts
  BreakdownSearch(const FaceCurves& face, const FaceSurfaceOptions& surface, double least);

  /// Asked before each surface; false ends the search with what is known.
  void setProgress(const std::function<bool()>& goOn) { goOn_ = goOn; }

  /// @param coarse  among the values of a sweep (findBreakdowns()); where nothing was found it is returned as it is
  SweepBreakdown refine(const SweepBreakdown& coarse) const;

 private:
  FaceCurves face_;
  FaceSurfaceOptions surface_;
  double least_;
  std::function<bool()> goOn_;
};

}  // namespace mien
