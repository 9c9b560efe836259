#pragma once

#include "MienSurfaceModule.h"
#include "Progress.h"
#include "vtkSmartPointer.h"

class vtkPolyData;

namespace mien {

/// A measured surface as it is drawn: cut along a smooth edge into what counts as covered and what does not, of which
/// `Distance` is no number and `DistanceVector` is 0.
///
/// Whether a point is covered changes to and fro near the edge and around holes of the other surface, as the mouth of a
/// scan: parts of less than 1 % of the points, and of less than half of what they are joined with, count as what is
/// around them, and the edge is that of the mean over the neighbours, taken 60 times, at one half. Points at equal
/// coordinates are one, so that triangles with corners of their own each are joined as they look.
///
/// @param surface   with the point arrays `Covered`, `Distance` and `DistanceVector` of vtkSurfaceDistanceFilter
/// @param progress  told how far it is, and asked whether to go on
/// @return all is covered: the surface itself; nullptr: stopped
MIENSURFACE_EXPORT vtkSmartPointer<vtkPolyData> coveredApart(vtkPolyData* surface, const Progress& progress = {});

}  // namespace mien
