#pragma once

#include <array>
#include <string>
#include <vector>

#include "MeshText.h"
#include "MienAcquisitionModule.h"
#include "Progress.h"

namespace mien {

/// What a scan holds. Lengths in the unit of the file.
struct ScanSummary {
  long long points = 0, triangles = 0;  ///< triangles after larger polygons were split
  PolygonCounts polygons;               ///< as the file has them
  int mergedVertices = 0, degenerateTriangles = 0;
  int components = 0;                         ///< parts that share no vertex, points at one place merged
  double largestShare = 1.0;                  ///< of the area, in the largest of them
  int boundaryLoops = 0, loopsOfLargest = 0;  ///< rims and holes, of all parts and of the largest
  std::array<double, 3> low = {}, high = {};  ///< corners of the box around it
  std::string unit;                           ///< "mm", "cm", "m" or "inch"; "" where it cannot be told
  double millimetres = 0.0;                   ///< of that unit
  std::string unitFault;                      ///< why it cannot be told
  std::vector<std::string> possibleUnits;     ///< those that the size allows
};

/// Reads a scan (.ply, .obj, .stl, .off) and looks at it; the unit is guessed as by `mien acquire` without landmarks.
/// @return nothing, or "FILE: what is wrong and what to do"
MIENACQUISITION_EXPORT std::string summarizeScan(const std::string& file, ScanSummary& summary,
                                                 const Progress& progress = {});

}  // namespace mien
