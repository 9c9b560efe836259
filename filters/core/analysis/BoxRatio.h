#pragma once

#include "FaceCurves.h"
#include "FaceSample.h"

namespace mien {

/// The factor by which the bounding box of the curves must grow about its middle to hold the surface; 1 or less where
/// nothing leaves it.
double boxRatio(const FaceSample& sample, const ClosedCurves& curves);

}  // namespace mien
