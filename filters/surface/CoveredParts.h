#pragma once

#include "MienSurfaceModule.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// A measured surface as it is drawn: cut along a smooth edge into what counts as covered and what does not, of which
/// `Distance` is no number and `DistanceVector` is 0.
///
/// Whether a point is covered changes to and fro near the edge and around holes of the other surface, as the mouth of a
/// scan: parts of less than 1 % of the points count as what is around them, and the edge is that of the mean over the
/// neighbours, taken 60 times, at one half.
///
/// @param surface  with the point arrays `Covered`, `Distance` and `DistanceVector` of vtkSurfaceDistanceFilter
/// @return all is covered: the surface itself
MIENSURFACE_EXPORT vtkSmartPointer<vtkPolyData> coveredApart(vtkPolyData* surface);

}  // namespace mien
