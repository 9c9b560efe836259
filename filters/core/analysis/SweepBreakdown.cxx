#include "SweepBreakdown.h"

#include <algorithm>

namespace mien {

namespace {

double valueOf(const SweepRecord& record, const char* measure) {
  return record.values[sweepMeasure(measure)];
}

/// Why a surface is no face, or nothing.
std::string breakdownOf(const SweepRecord& record, int cells) {
  if (!record.reason.empty()) return record.reason;
  if (!(valueOf(record, "box_ratio") <= SweepBreakdown::largestBoxRatio))
    return "the surface leaves the curves' bounding box";
  if (!(valueOf(record, "folded_cells") <= SweepBreakdown::largestFoldedShare * cells)) return "the surface folds";
  return {};
}

}  // namespace

std::vector<SweepBreakdown> findBreakdowns(const std::vector<SweepRecord>& records, int rows, int columns) {
  const int cells = (rows - 1) * columns;
  std::vector<SweepBreakdown> breakdowns;
  for (const SweepRecord& record : records) {
    auto found =
        std::find_if(breakdowns.begin(), breakdowns.end(), [&](const auto& b) { return b.scheme == record.scheme; });
    if (found == breakdowns.end()) {
      breakdowns.push_back({record.scheme, false, 0.0, {}});
      found = breakdowns.end() - 1;
    }
    const std::string reason = breakdownOf(record, cells);
    if (!reason.empty() && (!found->found || record.smoothing < found->smoothing))
      *found = {record.scheme, true, record.smoothing, reason};
  }
  return breakdowns;
}

}  // namespace mien
