#include "SweepFigure.h"

#include "AxisScale.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

struct Panel {
  const char* measure;
  const char* title;
  const char* unit;
};

const Panel panels[] = {{"area_mm2", "Area", "mm²"},
                        {"rms_departure_mm", "RMS departure", "mm"},
                        {"max_departure_mm", "Largest departure", "mm"},
                        {"curve_miss_rms_mm", "RMS miss of curves", "mm"},
                        {"lebesgue", "Lebesgue constant", ""},
                        {"g1_max_deg", "Largest seam angle", "degrees"},
                        {"folded_cells", "Folded cells", ""},
                        {"willmore_energy", "Willmore energy", ""},
                        {"distance_rms_mm", "RMS distance to scan", "mm"}};

// Below this values are rounding; drawing them would take most of an axis.
constexpr double leastShownMillimetres = 1e-6;

bool isMillimetres(const Panel& panel) { return std::string(panel.unit) == "mm"; }

double shown(const Panel& panel, double value) {
  if (isMillimetres(panel) && value < leastShownMillimetres) return 0.0;
  return value;
}

std::vector<std::string> schemesOf(const std::vector<SweepRecord>& records) {
  std::vector<std::string> schemes;
  for (const SweepRecord& record : records)
    if (std::find(schemes.begin(), schemes.end(), record.scheme) == schemes.end()) schemes.push_back(record.scheme);
  return schemes;
}

ChartSeries seriesOf(const std::vector<SweepRecord>& records, const std::string& scheme, const Panel& panel, size_t column) {
  ChartSeries series;
  series.name = scheme;
  std::vector<std::pair<double, double>> points;  // a list of a need not be in order
  for (const SweepRecord& record : records)
    if (record.scheme == scheme && column < record.values.size())
      points.emplace_back(record.smoothing, shown(panel, record.values[column]));
  std::sort(points.begin(), points.end(), [](const auto& one, const auto& other) { return one.first < other.first; });
  for (const auto& [a, value] : points) {
    series.x.push_back(a);
    series.y.push_back(value);
  }
  return series;
}

bool hasValues(const Chart& chart) {
  for (const ChartSeries& series : chart.series)
    for (const double value : series.y)
      if (std::isfinite(value)) return true;
  return false;
}

Chart chartOf(const std::vector<SweepRecord>& records, const std::map<std::string, double>& breakdowns, const Panel& panel,
              size_t column) {
  Chart chart;
  chart.x.title = "a";
  chart.x.scale = ChartAxis::Scale::Automatic;
  chart.x.endsWithData = true;
  chart.y = ChartAxis{panel.title, panel.unit, ChartAxis::Scale::Automatic};
  for (const std::string& scheme : schemesOf(records)) {
    chart.series.push_back(seriesOf(records, scheme, panel, column));
    const auto breakdown = breakdowns.find(scheme);
    if (breakdown != breakdowns.end()) chart.series.back().breakdown = breakdown->second;
  }
  return chart;
}

}  // namespace

Figure sweepFigure(const std::vector<SweepRecord>& records, const std::map<std::string, double>& breakdowns, double reference) {
  Figure figure;
  for (const Panel& panel : panels) {
    const int column = sweepMeasure(panel.measure);
    if (column < 0) continue;
    const Chart chart = chartOf(records, breakdowns, panel, column);
    if (hasValues(chart)) figure.panels.push_back(chart);
  }
  figure.title = "The smoothing parameter a";
  figure.caption = "Measures of the surface over a; departures are from the same scheme's surface at a = " +
                   tickText(reference, reference) + ". Below 0.000001 mm lengths are drawn as 0.";
  if (!breakdowns.empty()) figure.caption += " From the crosses on a surface is no face any more.";
  return figure;
}

}  // namespace mien
