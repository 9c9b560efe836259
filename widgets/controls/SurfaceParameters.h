#pragma once

#include <string>

#include "FaceSurface.h"

class vtkPDEFaceAlgorithm;

namespace mien {

/// Gives a filter the parameters of the surface that is shown.
void setParameters(const FaceSurfaceOptions& options, vtkPDEFaceAlgorithm* filter);

/// "spline, a = 1, N = 5, with remainder": what stands below a figure so that it can be made again.
std::string parameterText(const FaceSurfaceOptions& options);

}  // namespace mien
