#include "CsvText.h"

#include <charconv>

namespace mien {

std::string shortestText(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

std::string coordinatesEndingLine(const double point[3]) {
  std::string line;
  for (int axis = 0; axis < 3; ++axis) line += "," + shortestText(point[axis]);
  return line + "\n";
}

}  // namespace mien
