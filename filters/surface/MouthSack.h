#pragma once

#include "MienSurfaceModule.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// The dark inside of an open mouth as triangles, see MouthInside.h; empty for a closed one, and for curves that are no
/// face with lips. Its field array `Gap` tells how far the lips are apart, in mm.
/// @param curves  as in BoundaryCurveData.h, as they are shown; may be null
MIENSURFACE_EXPORT vtkSmartPointer<vtkPolyData> mouthSack(vtkPolyData* curves);

constexpr double mouthColor[3] = {0.24, 0.11, 0.10};  ///< without light: a mouth has none of its own

}  // namespace mien
