#pragma once

#include <string>
#include <vector>

#include "SmoothingSweep.h"

namespace mien {

/// Where a scheme breaks down as a grows: the smallest a whose surface is no face any more.
struct SweepBreakdown {
  /// The surface leaves the curves' bounding box by more than 3 percent, ...
  static constexpr double largestBoxRatio = 1.03;
  /// ... or this share of its front is turned over (TurnedArea.h); doc/decisions.md has the figures.
  static constexpr double largestTurnedShare = 0.005;

  std::string scheme;
  bool found = false;
  double smoothing = 0.0;  ///< a
  std::string reason;      ///< which of the criteria, or why the scheme refuses

  /// Which criterion these measures of a surface fail, or nothing.
  static std::string reasonOf(double boxRatio, double turnedShare);
};

/// Among the values of a sweep: one entry per scheme, in the order of the records.
std::vector<SweepBreakdown> findBreakdowns(const std::vector<SweepRecord>& records);

}  // namespace mien
