#pragma once

#include "FaceFrame.h"

class vtkStructuredGrid;

namespace mien {

/// Sides of lips and lids of a whole PDE face (vtkPDEFaceFilter) by u; empty for a grid without its `PatchId`.
std::vector<FaceSide> gridFaceSides(vtkStructuredGrid* grid, const FacialRegions& regions, const FaceFrame& frame);

}  // namespace mien
