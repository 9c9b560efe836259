#pragma once

#include <cmath>

#include "Figure.h"

namespace mien {

/// Six series that grow at different rates over five decades, two of which break down.
inline Chart sampleChart() {
  Chart chart;
  chart.x = {"Smoothing parameter a", "", ChartAxis::Scale::Logarithmic};
  chart.x.endsWithData = true;
  chart.y = {"Lebesgue constant", "", ChartAxis::Scale::Automatic};
  const char* const names[] = {"four-curve", "derivative", "sixth-order", "tangent", "curvature", "spline"};
  for (int s = 0; s < 6; ++s) {
    ChartSeries series;
    series.name = names[s];
    for (int i = 0; i <= 40; ++i) {
      const double a = std::pow(10.0, -1.0 + i * 0.075);
      series.x.push_back(a);
      series.y.push_back(1.0 + 0.1 * s + (s % 3 == 0 && s < 5 ? std::expm1(0.3 * a) : 0.05 * a));
      if (!series.breakdown && series.y.back() > 10.0 && s % 3 == 0) series.breakdown = a;
    }
    chart.series.push_back(series);
  }
  chart.marks.push_back({1.0, false, "reference, a = 1"});
  return chart;
}

/// Bars on named positions.
inline Chart sampleBars() {
  Chart chart;
  chart.x.title = "Mode n";
  chart.y = {"RMS length of the contribution", "mm", ChartAxis::Scale::Automatic};
  chart.x.categories = {"0", "1", "2", "3", "4", "5", "remainder"};
  chart.series.push_back(
      {"contribution", {0, 1, 2, 3, 4, 5, 6}, {60.0, 75.0, 6.0, 3.0, 1.5, 0.8, 0.4}, ChartSeries::Kind::Bars});
  return chart;
}

inline Figure sampleFigure() {
  Figure figure;
  figure.title = "Smoothing parameter and the schemes";
  figure.panels = {sampleChart(), sampleBars()};
  figure.caption = "Two charts with everything that charts can have.";
  figure.note = "schemes four-curve to spline; a from 0.1 to 100; N = 5";
  return figure;
}

}  // namespace mien
