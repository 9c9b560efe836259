#pragma once

#include <string>
#include <vector>

#include "SmoothingSweep.h"

namespace mien {

/// Where a scheme breaks down as a grows: the smallest a of a sweep whose surface is no face any more.
struct SweepBreakdown {
  /// The surface leaves the curves' bounding box by more than 3 percent, ...
  static constexpr double largestBoxRatio = 1.03;
  /// ... or this share of all cells is folded; doc/decisions.md has the figures.
  static constexpr double largestFoldedShare = 0.005;

  std::string scheme;
  bool found = false;
  double smoothing = 0.0;  ///< a
  std::string reason;      ///< which of the criteria, or why the scheme refuses
};

/// One entry per scheme, in the order of the records.
std::vector<SweepBreakdown> findBreakdowns(const std::vector<SweepRecord>& records, int rows, int columns);

}  // namespace mien
