#pragma once

#include <string>
#include <vector>

#include "FaceSides.h"

class vtkPointSet;

namespace mien {

/// The edges of the visible cells (polygons, triangles, quads, lines). @return nothing, or which cell names a point
/// that is not there
std::string readEdges(vtkPointSet* data, MeshEdges& edges);

/// Unit normals at the points, of the polygons around each by area, outwards by the sign of the volume they enclose; 0
/// for a point without polygons. Empty when there are no polygons, or one of them names a point that is not there.
std::vector<Eigen::Vector3d> polygonNormals(vtkPointSet* data);

}  // namespace mien
