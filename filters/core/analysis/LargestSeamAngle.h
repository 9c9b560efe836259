#pragma once

#include "FaceSample.h"

namespace mien {

/// The largest angle between the normals of the two patches at any of the eight seams (degrees, 0 .. 180). Where the
/// lips are apart there is no seam.
double largestSeamAngle(const FaceSample& sample);

}  // namespace mien
