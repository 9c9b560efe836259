#pragma once

#include "MienAnimationModule.h"
#include "vtkDoubleArray.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// How far every point of animated curves has moved from the neutral face, mm: the length of `Displacement`
/// (vtkFAPAnimationFilter, vtkFDTCurveFilter), or, without the head's rotation, of what is left of it in the head's own
/// frame.
/// @return nullptr for curves that have no displacements
MIENANIMATION_EXPORT vtkSmartPointer<vtkDoubleArray> curveMovement(vtkPolyData* curves, bool withoutHead);

}  // namespace mien
