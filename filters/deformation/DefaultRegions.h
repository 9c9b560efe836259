#pragma once

#include "FacialRegions.h"
#include "MienDeformationModule.h"

namespace mien {

/// The region map of data/deformation/regions.json, which is compiled in.
MIENDEFORMATION_EXPORT const FacialRegions& defaultRegions();

}  // namespace mien
