#pragma once

#include "vtkSmartPointer.h"

class vtkLookupTable;

namespace mien {

/// Viridis: perceptually uniform, and in order without colour vision too.
vtkSmartPointer<vtkLookupTable> sequentialColors(double smallest, double largest);

/// The colours of the patches 0 .. 8.
vtkSmartPointer<vtkLookupTable> patchColorTable();

}  // namespace mien
