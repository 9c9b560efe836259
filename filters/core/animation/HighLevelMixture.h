#pragma once

#include "FAPFrame.h"

namespace mien {

/// FAP 1 between two frames: every viseme with the linear mixture of its weights. What a frame does not select has
/// weight 0 there.
/// @param weight  0 .. 1, of the frame after
/// @return that of the frame before where the two select nothing, or more than the two that a frame has room for, or
/// differ in how they define
Viseme mixture(const Viseme& before, const Viseme& after, double weight);

/// The same of FAP 2.
Expression mixture(const Expression& before, const Expression& after, double weight);

}  // namespace mien
