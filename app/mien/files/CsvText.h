#pragma once

#include <string>

namespace mien {

/// The shortest text that reads back to the same number, in the C locale.
std::string shortestText(double value);

/// ",x,y,z" and the end of the line.
std::string coordinatesEndingLine(const double point[3]);

}  // namespace mien
