#include "ContinuityFigure.h"

#include <algorithm>
#include <cmath>

#include "AxisScale.h"
#include "SchemeStyle.h"

namespace mien {

namespace {

constexpr double quarterTurn = 90.0;
constexpr double mostRounding = 1e-9;  // in any unit: what is smaller is not a property of the surface

std::vector<std::string> seamsOf(const std::vector<SeamProfile>& profiles) {
  std::vector<std::string> seams;
  for (const SeamProfile& profile : profiles)
    if (std::find(seams.begin(), seams.end(), profile.seam) == seams.end()) seams.push_back(profile.seam);
  return seams;
}

double largestOf(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, value);
  return largest;
}

/// One scale for all panels, or they could not be compared.
ChartAxis commonAxis(const std::vector<SeamProfile>& profiles, const ChartAxis& measure) {
  std::vector<double> values;
  for (const SeamProfile& profile : profiles) values.insert(values.end(), profile.value.begin(), profile.value.end());
  ChartAxis axis = measure;
  const double largest = largestOf(values);
  if (largest == 0.0) axis.end = 1.0;
  if (measure.unit == "degrees" && largest > quarterTurn) {
    axis.end = 2.0 * quarterTurn;  // all that an angle between normals can be
    axis.step = 0.5 * quarterTurn;
  }
  const AxisScale scale = AxisScale::around(axis, values, true);
  axis.scale = scale.logarithmic() ? ChartAxis::Scale::Logarithmic : ChartAxis::Scale::Linear;
  axis.begin = scale.begin();
  axis.end = scale.end();
  return axis;
}

Chart seamChart(const std::string& seam, const std::vector<SeamProfile>& profiles, const ChartAxis& y) {
  Chart chart;
  chart.x = ChartAxis{"v", "degrees"};
  chart.x.begin = 0.0;
  chart.x.end = 4.0 * quarterTurn;
  chart.x.step = quarterTurn;
  chart.y = y;
  chart.y.title = seam + ", " + y.title;
  double largest = 0.0;
  for (const SeamProfile& profile : profiles) {
    if (profile.seam != seam) continue;
    chart.series.push_back(
        {profile.scheme, profile.v, profile.value, ChartSeries::Kind::Line, schemeStyle(profile.scheme)});
    largest = std::max(largest, largestOf(profile.value));
  }
  if (largest < mostRounding) chart.y.title += largest > 0.0 ? ": rounding only" : ": 0 everywhere";
  return chart;
}

}  // namespace

Figure continuityFigure(const std::vector<SeamProfile>& profiles, const ChartAxis& measure) {
  Figure figure;
  const ChartAxis axis = commonAxis(profiles, measure);
  for (const std::string& seam : seamsOf(profiles)) figure.panels.push_back(seamChart(seam, profiles, axis));
  figure.title = "Continuity across the seams";
  figure.caption =
      "Measured from both sides of each seam along v; the back of the head is at 0, the nose bridge at 180 degrees.";
  return figure;
}

}  // namespace mien
