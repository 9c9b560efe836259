#include "GridResolution.h"

namespace mien {

std::string describeResolutionFault(int rows, int columns, int smallestRows) {
  const std::string asked = "a resolution of " + std::to_string(rows) + "x" + std::to_string(columns);
  if (rows < smallestRows || columns < smallestColumns)
    return asked + " is too coarse; at least " + std::to_string(smallestRows) + "x" + std::to_string(smallestColumns) +
           " is needed";
  if (static_cast<double>(rows) * columns > mostGridPoints)
    return asked + " is too fine; at most " + std::to_string(static_cast<long>(mostGridPoints)) + " points are allowed";
  return {};
}

}  // namespace mien
