#pragma once

#include "Figure.h"

namespace mien {

/// How the effect of a curve's move fades down the face in one scheme.
struct InfluenceProfile {
  std::string scheme;
  std::vector<double> curve;      ///< position down the face counted in curves, 1 at C1
  std::vector<double> influence;  ///< largest move of the row, mm per mm
};

/// @param moved     position of the curve that moves
/// @param movement  "C10 moves": the line in the legend
Figure influenceFigure(const std::vector<InfluenceProfile>& profiles, double moved, const std::string& movement);

}  // namespace mien
