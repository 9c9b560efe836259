#pragma once

#include "SeamSummary.h"

namespace mien {

/// A column of the tables that summarise seams.
struct SeamColumn {
  const char* name;
  double SeamMeasures::*measure;
  bool isMean;  ///< else the largest

  double of(const SeamSummary& summary) const { return (isMean ? summary.mean() : summary.max()).*measure; }
};

inline constexpr SeamColumn seamColumns[] = {
    {"g0_max_mm", &SeamMeasures::g0, false},     {"g1_mean_deg", &SeamMeasures::g1, true},
    {"g1_max_deg", &SeamMeasures::g1, false},    {"c1_max", &SeamMeasures::c1, false},
    {"g2_max_per_mm", &SeamMeasures::g2, false}, {"c2_max", &SeamMeasures::c2, false}};

}  // namespace mien
