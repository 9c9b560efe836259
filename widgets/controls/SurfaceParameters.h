#pragma once

#include "FaceSurface.h"

class vtkPDEFaceAlgorithm;

namespace mien {

/// Gives a filter the parameters of the surface that is shown.
void setParameters(const FaceSurfaceOptions& options, vtkPDEFaceAlgorithm* filter);

}  // namespace mien
