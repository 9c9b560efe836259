#pragma once

#include "FaceCurves.h"
#include "FaceSurface.h"

namespace mien {

/// The RMS distance between the samples of all 29 curves and the surface at the same (u, v), mm: rounding where a
/// scheme passes its curves, else how far it misses them.
double curveMiss(const FaceCurves& face, const FaceSurfaceOptions& options);

}  // namespace mien
