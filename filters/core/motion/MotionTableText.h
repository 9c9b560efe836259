#pragma once

#include <string>
#include <vector>

#include "MotionField.h"

namespace mien {

/// Vectors of a field as lines of numbers between commas: u, v (empty on meshes without them), x, y, z, dx, dy, dz,
/// magnitude_mm, below a line with these names; u over the whole face 0 .. 1, v in radians, all else in mm.
/// @param chosen  rows of the field
std::string motionTableText(const MotionField& field, const std::vector<int>& chosen);

}  // namespace mien
