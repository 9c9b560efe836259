#include "DetailFigure.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr auto logarithmicScale = ChartAxis::Scale::Logarithmic;

bool hasDistance(const DetailPoint& point) {
  return std::isfinite(point.rms) && point.rms > 0.0;
}

/// Compact faces last, so that others do not hide their few points.
const std::vector<std::pair<const char*, int>> representations = {
    {"modes", 0}, {"decimated mesh", 2}, {"packed mesh", 3}, {"compact face", 1}};  // with their styles

/// The values with a little room, not up to the next decade.
void closeAxis(ChartAxis& axis, const std::vector<ChartSeries>& series, std::vector<double> values,
               std::vector<double> ChartSeries::*coordinate) {
  constexpr double room = 1.25;
  for (const ChartSeries& one : series) values.insert(values.end(), (one.*coordinate).begin(), (one.*coordinate).end());
  if (values.empty()) return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  axis.begin = *least / room;
  axis.end = *most * room;
}

ChartSeries seriesOf(std::vector<DetailPoint> points, const std::string& name, double DetailPoint::*measure) {
  std::sort(points.begin(), points.end(), [](const auto& one, const auto& other) { return one.bytes < other.bytes; });
  ChartSeries series;
  series.name = name;
  series.kind = ChartSeries::Kind::Samples;
  for (const DetailPoint& point : points)
    if (point.representation == name && hasDistance(point)) {
      series.x.push_back(point.bytes);
      series.y.push_back(point.*measure);
    }
  return series;
}

Chart chartOf(const std::vector<DetailPoint>& points, const char* title, double DetailPoint::*measure,
              double curveBytes) {
  Chart chart;
  chart.x = ChartAxis{"Size", "bytes", logarithmicScale};
  chart.y = ChartAxis{title, "mm", logarithmicScale};
  for (const auto& [name, style] : representations) {
    ChartSeries series = seriesOf(points, name, measure);
    series.style = style;
    if (!series.x.empty()) chart.series.push_back(series);
  }
  closeAxis(chart.x, chart.series, {curveBytes}, &ChartSeries::x);
  closeAxis(chart.y, chart.series, {}, &ChartSeries::y);
  chart.marks.push_back({curveBytes, false, "all points of the curves"});
  return chart;
}

}  // namespace

Figure detailFigure(const std::vector<DetailPoint>& points, double curveBytes, const std::string& reference) {
  Figure figure;
  figure.panels = {chartOf(points, "RMS distance", &DetailPoint::rms, curveBytes),
                   chartOf(points, "Hausdorff distance", &DetailPoint::largest, curveBytes)};
  figure.title = "Size against distance to " + reference;
  figure.caption =
      "Distances between " + reference +
      " and what is kept of it, the larger of both ways. Meshes are the part of it that the face covers, "
      "decimated; plain ones keep single precision coordinates and 16 bit indices, packed ones and compact "
      "faces are rounded and entropy-coded.";
  return figure;
}

}  // namespace mien
