#pragma once

#include "vtkSmartPointer.h"

class vtkLookupTable;

namespace mien {

/// Viridis: perceptually uniform, and in order without colour vision too.
vtkSmartPointer<vtkLookupTable> sequentialColors(double smallest, double largest);

/// One colour for each patch 0 .. 8, told apart without colour vision too (Paul Tol's muted scheme).
vtkSmartPointer<vtkLookupTable> patchColors();

}  // namespace mien
