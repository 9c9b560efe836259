#pragma once

#include <string>

#include "MienSurfaceModule.h"

class vtkPolyData;

namespace mien {

/// Writes polydata as XML, inline and not compressed, so that it is read wherever .vtp is; under a temporary name, see
/// WholeFile.h. @return whether it was written
MIENSURFACE_EXPORT bool fillPolyData(vtkPolyData* data, const std::string& name);

}  // namespace mien
