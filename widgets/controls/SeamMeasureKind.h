#pragma once

#include <string>
#include <vector>

#include "ChartAxis.h"

namespace mien {

/// One of the measures across a seam, as vtkPatchContinuityFilter names them and as people read them.
struct SeamMeasureKind {
  std::string array;  ///< point array
  ChartAxis axis;     ///< title and unit
  std::string toolTip;
  double leastRange;    ///< of colours; below it a difference cannot be seen on a face
  double largestRange;  ///< that there can be

  static const std::vector<SeamMeasureKind>& all();
};

/// A column of the filter's summary.
struct SeamSummaryColumn {
  const char* name;    ///< without the prefix "frontal_"
  const char* header;  ///< with unit
  const char* toolTip;

  static const std::vector<SeamSummaryColumn>& all();
};

}  // namespace mien
