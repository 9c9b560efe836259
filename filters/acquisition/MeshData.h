#pragma once

#include <string>

#include "MienAcquisitionModule.h"
#include "TriangleMesh.h"

class vtkPolyData;

namespace mien {

/// Triangles of a polydata (polygons are split into fans, strips are not read).
/// @return nothing, or one sentence that says what makes the mesh unusable
MIENACQUISITION_EXPORT std::string readTriangleMesh(vtkPolyData* data, TriangleMesh& mesh);

/// A polydata of triangles with double precision points.
void writeTriangleMesh(const TriangleMesh& mesh, vtkPolyData* data);

}  // namespace mien
