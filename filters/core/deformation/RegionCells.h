#pragma once

#include "FacialRegions.h"

namespace mien {

/// A polygon in the plane, pupil units.
using PlanePolygon = std::vector<Eigen::Vector2d>;

/// The face's outline: where tables count by one half.
PlanePolygon faceOutline(const FacialRegions& regions);

/// The hard region of every point within the outline, by place alone: for each of the 16 the part of the outline that
/// is nearer to its centre than to any other. Counter-clockwise; empty for a region that has no part of it.
std::vector<PlanePolygon> regionCells(const FacialRegions& regions);

}  // namespace mien
