#pragma once

#include <string>

namespace mien {

constexpr int smallestColumns = 3;
constexpr double mostGridPoints = 134217728.0;  ///< rows x columns; about 3 GB with normals, single precision

/// One sentence when a uv mesh of rows x columns (the closing one not counted) is too coarse or too fine, or nothing.
std::string describeResolutionFault(int rows, int columns, int smallestRows);

}  // namespace mien
