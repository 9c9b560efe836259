#pragma once

#include <string>

namespace mien {

constexpr int smallestColumns = 3;
constexpr double mostGridPoints = 134217728.0;  ///< rows x columns; about 3 GB with normals, single precision
constexpr int mostGridLines = 100000;           ///< rows, and columns, of a mesh that is made in parts

/// One sentence when a uv mesh of rows x columns (the closing one not counted) is too coarse or too fine, or nothing.
std::string describeResolutionFault(int rows, int columns, int smallestRows);

/// The same of a mesh that is made in parts, whose points as a whole need not fit into memory.
std::string describePartedResolutionFault(int rows, int columns, int smallestRows);

/// One sentence when a part of rows x columns is too large to be made at once, or nothing.
std::string describePartFault(int rows, int columns);

}  // namespace mien
