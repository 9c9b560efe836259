#pragma once

#include "MienSurfaceModule.h"
#include "Progress.h"

class vtkAlgorithm;

namespace mien {

/// Updates a filter, which tells `progress` how far it is and is aborted when that says so.
/// @return whether it ran to its end
MIENSURFACE_EXPORT bool updateWith(const Progress& progress, vtkAlgorithm* algorithm);

}  // namespace mien
