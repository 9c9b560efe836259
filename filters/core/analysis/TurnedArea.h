#pragma once

#include "FaceSample.h"

namespace mien {

/// The share of a face's front (z > 50 mm) whose normal is turned by more than 90 degrees against that of another face
/// at the same (u, v): 0 .. 1, weighted with the other's area. Unlike a number of folded cells it has a limit as the
/// grid gets finer.
///
/// @param reference  sampled at the same rows and columns
double turnedAreaShare(const FaceSample& sample, const FaceSample& reference);

}  // namespace mien
