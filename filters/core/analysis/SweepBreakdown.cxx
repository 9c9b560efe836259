#include "SweepBreakdown.h"

#include <algorithm>

namespace mien {

namespace {

/// Why a surface is no face, or nothing.
std::string breakdownOf(const SweepRecord& record) {
  if (!record.reason.empty()) return record.reason;
  return SweepBreakdown::reasonOf(sweepValue(record, "box_ratio"), sweepValue(record, "turned_area_share"));
}

}  // namespace

std::string SweepBreakdown::reasonOf(double boxRatio, double turnedShare) {
  if (!(boxRatio <= largestBoxRatio)) return "the surface leaves the curves' bounding box";
  if (!(turnedShare <= largestTurnedShare)) return "the surface folds over";
  return {};
}

std::vector<SweepBreakdown> findBreakdowns(const std::vector<SweepRecord>& records) {
  std::vector<SweepBreakdown> breakdowns;
  for (const SweepRecord& record : records) {
    auto found =
        std::find_if(breakdowns.begin(), breakdowns.end(), [&](const auto& b) { return b.scheme == record.scheme; });
    if (found == breakdowns.end()) {
      breakdowns.push_back({record.scheme, false, 0.0, {}});
      found = breakdowns.end() - 1;
    }
    const std::string reason = breakdownOf(record);
    if (!reason.empty() && (!found->found || record.smoothing < found->smoothing))
      *found = {record.scheme, true, record.smoothing, reason};
  }
  return breakdowns;
}

}  // namespace mien
