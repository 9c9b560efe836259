#pragma once

#include "FaceSample.h"

namespace mien {

/// The area of all patches, the integral of |S_u x S_v| (mm2).
double faceArea(const FaceSample& sample);

}  // namespace mien
