#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mien {

/// Values of one thing over an axis. A value that is not finite leaves a gap.
struct ChartSeries {
  enum class Kind {
    Line,     ///< with a few markers, which tell lines apart without colours
    Samples,  ///< a line with a marker at every value
    Bars      ///< at categories; several series stand side by side
  };

  std::string name;  ///< in the legend; empty: not there
  std::vector<double> x, y;
  Kind kind = Kind::Line;
  int style = -1;                        ///< colour, dashes and marker 0 .. 5; -1: the position in the chart
  std::optional<double> breakdown = {};  ///< the first x whose value means nothing any more: marked with a cross
};

}  // namespace mien
