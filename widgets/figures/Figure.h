#pragma once

#include "Chart.h"

namespace mien {

/// Charts side by side with one legend, labelled (a), (b) .. when there are several.
struct Figure {
  std::string title;  ///< above the charts; may be empty
  std::vector<Chart> panels;
  int columns = 0;       ///< of panels; 0: as many as fit legibly
  bool labelled = true;  ///< (a), (b) .. before several panels
  int firstLabel = 0;    ///< of the first panel: 1 starts with (b), behind panels of another kind
  std::string caption;   ///< below: what is seen
  std::string note;      ///< below, smaller: scheme, a, N, resolution, so that the figure can be made again
};

}  // namespace mien
