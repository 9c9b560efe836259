#pragma once

#include "ChartAxis.h"
#include "ChartSeries.h"

namespace mien {

/// A line across a chart at one value, named in the legend: a tolerance, a reference.
struct ChartMark {
  double value = 0.0;
  bool horizontal = false;  ///< at a y; else at an x
  std::string name;
};

/// One panel of a figure. The title of its y axis stands above it.
struct Chart {
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  std::vector<ChartMark> marks;
};

}  // namespace mien
