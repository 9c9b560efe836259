#include "SeamMeasureKind.h"

#include <limits>

namespace mien {

namespace {

constexpr double unlimited = std::numeric_limits<double>::max();

}  // namespace

const std::vector<SeamMeasureKind>& SeamMeasureKind::all() {
  static const auto axis = [](const char* title, const char* unit) { return ChartAxis{title, unit}; };
  static const std::vector<SeamMeasureKind> kinds = {
      {"G1", axis("G1 angle", "degrees"), "Angle between the unit normals of both sides, in degrees", 1.0, 180.0},
      {"G0", axis("G0 gap", "mm"), "Distance between both sides, in mm", 0.01, unlimited},
      {"C1", axis("C1 jump", "relative"), "Jump of dS/du relative to its mean length (no unit)", 0.1, 2.0},
      {"G2", axis("G2 jump", "1/mm"), "Difference of the normal curvatures perpendicular to the seam, in 1/mm", 0.01,
       unlimited},
      {"C2", axis("C2 jump", "relative"), "Jump of d\u00b2S/du\u00b2 relative to its mean length (no unit)", 0.1, 2.0}};
  return kinds;
}

const std::vector<SeamSummaryColumn>& SeamSummaryColumn::all() {
  static const std::vector<SeamSummaryColumn> columns = {
      {"g0_max_mm", "G0 max\nmm", "Largest gap between both sides, in mm"},
      {"g1_mean_deg", "G1 mean\n\u00b0", "Mean angle between the unit normals of both sides, in degrees"},
      {"g1_max_deg", "G1 max\n\u00b0", "Largest angle between the unit normals of both sides, in degrees"},
      {"c1_max", "C1 max\nrelative", "Largest jump of dS/du relative to its mean length (no unit)"},
      {"g2_max_per_mm", "G2 max\n1/mm",
       "Largest difference of the normal curvatures perpendicular to the seam, in 1/mm"},
      {"c2_max", "C2 max\nrelative", "Largest jump of d\u00b2S/du\u00b2 relative to its mean length (no unit)"}};
  return columns;
}

}  // namespace mien
