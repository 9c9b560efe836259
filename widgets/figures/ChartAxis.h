#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mien {

/// One axis of a chart: what it measures, in which unit, and its scale.
struct ChartAxis {
  enum class Scale {
    Linear,
    Logarithmic,
    Automatic  ///< logarithmic when the positive values span more than a factor of 50
  };

  std::string title;
  std::string unit;  ///< "mm", "degrees"; empty for a pure number
  Scale scale = Scale::Linear;
  std::optional<double> begin = {}, end = {};  ///< without them the data decide
  double step = 0.0;                           ///< between labelled ticks of a linear axis, from `begin` on; 0: chosen
  bool endsWithData = false;                   ///< no room beyond the first and last value
  std::vector<std::string> categories = {};    ///< names of the positions 0, 1, 2 .. in place of numbers
};

/// "Area (mm)", or the title alone.
inline std::string titleWithUnit(const ChartAxis& axis) {
  return axis.unit.empty() ? axis.title : axis.title + " (" + axis.unit + ")";
}

}  // namespace mien
