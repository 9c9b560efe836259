#pragma once

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// Boundary curves as what they are between their samples, trigonometric interpolants: closed polylines with several
/// times the points. Input and output as in BoundaryCurveData.h; a polydata without curves gives one without lines.
vtkSmartPointer<vtkPolyData> smoothCurves(vtkPolyData* curves);

}  // namespace mien
