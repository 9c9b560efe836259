#include "SweepFigure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "AxisScale.h"
#include "OffScaleMarks.h"
#include "SchemeStyle.h"

namespace mien {

namespace {

constexpr auto linear = ChartAxis::Scale::Linear;
constexpr auto logarithmic = ChartAxis::Scale::Logarithmic;

struct Panel {
  const char* measure;
  const char* title;
  const char* unit;
  ChartAxis::Scale scale;
  double room;  ///< the axis ends at the largest value of a surface that is a face, times this
};

const Panel panels[] = {{"area_mm2", "Area", "mm²", linear, 1.0},
                        {"rms_departure_mm", "RMS departure", "mm", logarithmic, 10.0},
                        {"max_departure_mm", "Largest departure", "mm", logarithmic, 10.0},
                        {"curve_miss_rms_mm", "RMS miss of curves", "mm", linear, 1.5},
                        {"lebesgue", "Lebesgue constant", "", logarithmic, 100.0},
                        {"g1_max_deg", "Seam angle", "degrees", linear, 1.0},
                        {"folded_cells", "Folded cells", "", linear, 2.0},
                        {"willmore_energy", "Willmore energy", "", logarithmic, 100.0},
                        {"distance_rms_mm", "RMS to reference", "mm", linear, 1.5}};

constexpr double halfTurn = 180.0;
constexpr double leastMeasured = 1e-6;  // mm and degrees: below this values are rounding and would take most of an axis

constexpr double beyondBreakdown = 2.0;  // of a: how far the axis goes on where no scheme's surface is a face any more

double shown(const Panel& panel, double value) {
  return *panel.unit && value < leastMeasured ? 0.0 : value;  // which a logarithmic axis leaves out
}

std::vector<std::string> schemesOf(const std::vector<SweepRecord>& records) {
  std::vector<std::string> schemes;
  for (const SweepRecord& record : records)
    if (std::find(schemes.begin(), schemes.end(), record.scheme) == schemes.end()) schemes.push_back(record.scheme);
  return schemes;
}

ChartSeries seriesOf(const std::vector<SweepRecord>& records, const std::string& scheme, const Panel& panel,
                     size_t column) {
  ChartSeries series;
  series.name = scheme;
  series.style = schemeStyle(scheme);
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

/// The values of surfaces that are faces, up to each scheme's breakdown.
std::vector<double> soundValues(const Chart& chart) {
  std::vector<double> values;
  for (const ChartSeries& series : chart.series)
    for (size_t i = 0; i < series.x.size(); ++i)
      if (std::isfinite(series.y[i]) && (!series.breakdown || series.x[i] < *series.breakdown))
        values.push_back(series.y[i]);
  return values;
}

/// Where the axis of a ends soon after the last breakdown; nothing: with the data, which hold a face to the end.
std::optional<double> endAfterBreakdowns(const Chart& chart) {
  double least = std::numeric_limits<double>::infinity(), most = 0.0, last = 0.0;
  for (const ChartSeries& series : chart.series) {
    if (series.x.empty()) continue;
    if (!series.breakdown) return {};
    least = std::min(least, series.x.front());
    most = std::max(most, series.x.back());
    last = std::max(last, *series.breakdown);
  }
  const double end = beyondBreakdown * last;
  if (end > least && end < most) return end;
  return {};
}

/// Past its breakdown a measure can grow to 1e30, beside which nothing else would be seen: the line leaves the panel.
void limitAxis(Chart& chart, double room) {
  std::vector<double> values = soundValues(chart);
  double largest = 0.0, end = 0.0;
  for (const ChartSeries& series : chart.series)
    for (const double value : series.y)
      if (std::isfinite(value)) largest = std::max(largest, value);
  for (const double value : values) end = std::max(end, room * value);
  if (!values.empty()) values.push_back(std::min(end, largest));
  if (largest == 0.0) values = {0.0, 1.0};
  const AxisScale scale = AxisScale::around(chart.y, values, false);
  chart.y.begin = scale.begin();
  chart.y.end = scale.end();
  if (chart.y.unit != "degrees" || *chart.y.end <= 0.5 * halfTurn) return;
  chart.y.end = halfTurn;  // all that an angle between normals can be
  chart.y.step = 0.25 * halfTurn;
}

Chart chartOf(const std::vector<SweepRecord>& records, const std::map<std::string, double>& breakdowns,
              const Panel& panel, size_t column) {
  Chart chart;
  chart.x.title = "a";
  chart.x.scale = ChartAxis::Scale::Automatic;
  chart.x.endsWithData = true;
  chart.y = ChartAxis{panel.title, panel.unit, panel.scale};
  for (const std::string& scheme : schemesOf(records)) {
    chart.series.push_back(seriesOf(records, scheme, panel, column));
    const auto breakdown = breakdowns.find(scheme);
    if (breakdown != breakdowns.end()) chart.series.back().breakdown = breakdown->second;
  }
  limitAxis(chart, panel.room);
  chart.x.end = endAfterBreakdowns(chart);
  return chart;
}

bool leavesPanels(const Figure& figure) {
  return std::any_of(figure.panels.begin(), figure.panels.end(), OffScaleMarks::areNeeded);
}

/// With two digits: "6.3", "8".
std::string roundedText(double value) {
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 1.0), rounded = std::round(value / step) * step;
  return tickText(rounded, rounded == std::round(rounded) ? 1.0 : step);
}

std::string noFace(const Chart& chart) {
  return chart.series.size() == 1 ? "the surface is no face" : "no scheme's surface is a face";
}

/// Which schemes have no surface from some a on: "The curves of four-curve end where ..".
std::string earlyEnds(const std::vector<SweepRecord>& records) {
  std::string schemes;
  for (const std::string& scheme : schemesOf(records)) {
    double first = std::numeric_limits<double>::infinity();
    for (const SweepRecord& record : records)
      if (record.scheme == scheme && !record.reason.empty()) first = std::min(first, record.smoothing);
    if (std::isfinite(first))
      schemes +=
          (schemes.empty() ? "" : ", ") + scheme + " (at a = " + tickText(std::round(first * 10.0) / 10.0, 0.1) + ")";
  }
  return schemes.empty() ? ""
                         : "Curves end early where double precision holds no surface of the scheme: " + schemes + ".";
}

}  // namespace

std::string sweepAxisTitle(const Chart& panel) {
  if (!panel.x.end) return panel.x.title;
  return panel.x.title + " (beyond " + roundedText(*panel.x.end) + " " + noFace(panel) + ": off scale)";
}

Figure sweepFigure(const std::vector<SweepRecord>& records, const std::map<std::string, double>& breakdowns,
                   double reference) {
  Figure figure;
  for (const Panel& panel : panels) {
    const int column = sweepMeasure(panel.measure);
    if (column < 0) continue;
    const Chart chart = chartOf(records, breakdowns, panel, column);
    if (hasValues(chart)) figure.panels.push_back(chart);
  }
  figure.title = "The smoothing parameter a";
  const std::string origin = "a = " + tickText(reference, reference);
  figure.caption = "Measures of the surface over a. Departures are from the same scheme's surface at " + origin +
                   ", where they vanish and their curves have a gap.";
  if (!breakdowns.empty())
    figure.caption +=
        " The markers above a plot stand where a scheme's surface ceases to be a face: it leaves the box of its "
        "curves by more than 3 %, or more than 0.5 % of its front is turned over; beyond, its curve is thin.";
  if (!figure.panels.empty() && figure.panels.front().x.end)
    figure.caption += " The axes of a end at " + roundedText(*figure.panels.front().x.end) +
                      ", twice the last of these: beyond, " + noFace(figure.panels.front()) + ".";
  if (leavesPanels(figure)) figure.caption += " Triangles at the top of a panel stand where a curve leaves its scale.";
  const std::string ends = earlyEnds(records);
  if (!ends.empty()) figure.caption += " " + ends;
  return figure;
}

}  // namespace mien
