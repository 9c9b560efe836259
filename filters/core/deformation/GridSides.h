#pragma once

#include <functional>
#include <vector>

#include "FacialRegions.h"
#include "PupilNormalisation.h"

namespace mien {

/// The slits of a face's uv mesh, rows down the face, columns around it.
struct GridSlits {
  int rows = 0, columns = 0;       ///< of points
  int upperLip = -1;               ///< row of the upper lip's contour, the next is the lower's; -1: none
  int openBegin = 0, openEnd = 0;  ///< columns of the mouth's corners
  double upperLid = -1.0,
         lowerLid = -1.0;  ///< rows of the lids' curves, between rows where no row lies on them; -1: none
};

/// Sides of lips and lids on the PDE face by u: rows above the slit are its upper side. Along the lips they rise as 1 -
/// s^4 from the corners (s = +-1) to the middle; the lids have theirs within 0.45 pupil units of their pupil, and it
/// changes evenly between them, as the surface runs on across the open eye. Both fade with the distance to the slit in
/// the same column.
/// @param point  of a row and column, in the face's own unit
std::vector<FaceSide> gridSides(const GridSlits& slits, const std::function<Eigen::Vector3d(int, int)>& point,
                                const FacialRegions& regions, const PupilNormalisation& pupils);

}  // namespace mien
