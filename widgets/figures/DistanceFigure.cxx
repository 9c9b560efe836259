#include "DistanceFigure.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr int steps = 200;  // finer than a line of one point can show at 170 mm

std::vector<double> sortedLengths(const std::vector<double>& distances) {
  std::vector<double> lengths;
  for (const double distance : distances)
    if (std::isfinite(distance)) lengths.push_back(std::abs(distance));
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

ChartSeries shareNearer(const DistanceSample& sample) {
  ChartSeries series;
  series.name = sample.direction;
  const std::vector<double> lengths = sortedLengths(sample.distances);
  if (lengths.empty()) return series;
  for (int i = 0; i <= steps; ++i) {
    const double distance = lengths.back() * i / steps;
    const auto nearer = std::upper_bound(lengths.begin(), lengths.end(), distance) - lengths.begin();
    series.x.push_back(distance);
    series.y.push_back(100.0 * nearer / lengths.size());
  }
  return series;
}

}  // namespace

Figure distanceFigure(const std::vector<DistanceSample>& samples) {
  Chart chart;
  chart.x = ChartAxis{"Distance d", "mm"};
  chart.y = ChartAxis{"Points nearer than d", "%"};
  chart.y.begin = 0.0;
  chart.y.end = 100.0;
  for (const DistanceSample& sample : samples) chart.series.push_back(shareNearer(sample));
  Figure figure;
  figure.panels = {chart};
  figure.title = "Distance between two surfaces";
  figure.caption = "Share of each surface's points whose nearest point on the other surface is nearer than d.";
  return figure;
}

}  // namespace mien
