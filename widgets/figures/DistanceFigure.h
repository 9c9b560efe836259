#pragma once

#include "Figure.h"

namespace mien {

/// Distances of one surface's points to another surface.
struct DistanceSample {
  std::string direction;          ///< "scan.ply to face.vts"
  std::vector<double> distances;  ///< mm, of any sign
};

/// Which share of the points lies nearer than a distance, a line each way.
Figure distanceFigure(const std::vector<DistanceSample>& samples);

}  // namespace mien
