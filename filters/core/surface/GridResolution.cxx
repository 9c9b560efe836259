#include "GridResolution.h"

namespace mien {

namespace {

std::string grid(int rows, int columns) {
  return std::to_string(rows) + "x" + std::to_string(columns);
}

std::string describeCoarseness(int rows, int columns, int smallestRows) {
  if (rows >= smallestRows && columns >= smallestColumns) return {};
  return "a resolution of " + grid(rows, columns) + " is too coarse; at least " + grid(smallestRows, smallestColumns) +
         " is needed";
}

bool isTooLarge(int rows, int columns) {
  return static_cast<double>(rows) * columns > mostGridPoints;
}

std::string mostPoints() {
  return "at most " + std::to_string(static_cast<long>(mostGridPoints)) + " points are allowed";
}

}  // namespace

std::string describeResolutionFault(int rows, int columns, int smallestRows) {
  const std::string coarseness = describeCoarseness(rows, columns, smallestRows);
  if (!coarseness.empty() || !isTooLarge(rows, columns)) return coarseness;
  return "a resolution of " + grid(rows, columns) + " is too fine; " + mostPoints();
}

std::string describePartedResolutionFault(int rows, int columns, int smallestRows) {
  const std::string coarseness = describeCoarseness(rows, columns, smallestRows);
  if (!coarseness.empty() || (rows <= mostGridLines && columns <= mostGridLines)) return coarseness;
  return "a resolution of " + grid(rows, columns) + " is too fine; at most " + grid(mostGridLines, mostGridLines) +
         " is allowed";
}

std::string describePartFault(int rows, int columns) {
  if (!isTooLarge(rows, columns)) return {};
  return "a grid of " + grid(rows, columns) + " is too large to be made at once: " + mostPoints() +
         "; ask for it in pieces";
}

}  // namespace mien
