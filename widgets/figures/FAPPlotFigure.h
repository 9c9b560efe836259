#pragma once

#include "FAPSequence.h"
#include "Figure.h"

namespace mien {

/// One FAP of the plot.
struct PlottedFAP {
  int fap;           ///< 3 .. 68
  std::string name;  ///< in the legend; empty: not there
  int style;         ///< 0 .. 5, see ChartSeries
};

/// FAPs of an animation over time: values in FAP units from `begin` to `end` (s). What is longer than the eye can
/// follow is thinned, with all its peaks.
Figure fapPlotFigure(const FAPSequence& motion, const std::vector<PlottedFAP>& faps, double begin, double end);

}  // namespace mien
