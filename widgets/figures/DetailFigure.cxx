#include "DetailFigure.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr auto logarithmic = ChartAxis::Scale::Logarithmic;

bool hasDistance(const DetailPoint& point) {
  return std::isfinite(point.rms) && point.rms > 0.0;
}

std::vector<std::string> representationsOf(const std::vector<DetailPoint>& points) {
  std::vector<std::string> names;
  for (const DetailPoint& point : points)
    if (hasDistance(point) && std::find(names.begin(), names.end(), point.representation) == names.end())
      names.push_back(point.representation);
  return names;
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
  chart.x = ChartAxis{"Size", "bytes", logarithmic};
  chart.y = ChartAxis{title, "mm", logarithmic};
  for (const std::string& name : representationsOf(points)) chart.series.push_back(seriesOf(points, name, measure));
  chart.marks.push_back({curveBytes, false, "all points of the curves"});
  return chart;
}

}  // namespace

Figure detailFigure(const std::vector<DetailPoint>& points, double curveBytes) {
  Figure figure;
  figure.panels = {chartOf(points, "RMS distance", &DetailPoint::rms, curveBytes),
                   chartOf(points, "Hausdorff distance", &DetailPoint::largest, curveBytes)};
  figure.title = "Size against distance to the scan";
  figure.caption =
      "Distances between a scan and what is kept of it, the larger of both ways. Meshes are the part of the scan that "
      "the "
      "face covers, decimated; plain ones keep single precision coordinates and 16 bit indices, packed ones and "
      "compact "
      "faces are rounded and entropy-coded.";
  return figure;
}

}  // namespace mien
