#pragma once

#include <string>
#include <vector>

#include "MotionField.h"

namespace mien {

/// Vectors of a field as lines of numbers between commas: u, v (empty on meshes without them), x, y, z, dx, dy, dz,
/// magnitude_mm, below a line with these names; u over the whole face 0 .. 1, v in radians, all else in mm.
/// What is below 1e-9 mm is rounding and written as 0.
/// @param chosen  rows of the field
std::string motionTableText(const MotionField& field, const std::vector<int>& chosen);

/// One field of a series.
struct MotionTablePart {
  std::string frame;  ///< number as written in the animation
  const MotionField* field;
  const std::vector<int>* chosen;
};

/// The same for several frames one below the other, with the column frame before the others.
std::string motionTableText(const std::vector<MotionTablePart>& parts);

}  // namespace mien
