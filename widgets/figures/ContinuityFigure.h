#pragma once

#include "Figure.h"

namespace mien {

/// One measure along one seam of a face in one scheme.
struct SeamProfile {
  std::string scheme;
  std::string seam;       ///< "P0|P1"
  std::vector<double> v;  ///< degrees, 0 at the back of the head, 180 at the nose bridge
  std::vector<double> value;
};

/// A panel per seam, a line per scheme, one scale for all.
///
/// @param measure  the title and unit of what is drawn
Figure continuityFigure(const std::vector<SeamProfile>& profiles, const ChartAxis& measure);

}  // namespace mien
