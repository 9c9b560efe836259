#pragma once

#include "FaceSample.h"

namespace mien {

/// The integral of the squared mean curvature over all patches (no unit; 4 pi for a whole sphere). Points without a
/// tangent plane, such as lids in contact, are left out; kinks at seams have no part in it.
double willmoreEnergy(const FaceSample& sample);

}  // namespace mien
