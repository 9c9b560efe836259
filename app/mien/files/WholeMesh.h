#pragma once

#include <string>

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkPointSet;

namespace mien {

/// readMesh() with all that the file says of its points: polygons of any size, colours, normals and texture coordinates
/// (.ply, .obj) where VTK reads the same points; triangles alone where it does not.
vtkSmartPointer<vtkDataObject> readWholeMesh(const std::string& name);

/// writeMesh() of a mesh whose points moved. From .obj to .obj the file's own text is kept but for the vertices: faces,
/// texture coordinates, groups, materials, and normals, which are then those of before.
void writeMovedMesh(vtkPointSet* moved, const std::string& source, const std::string& name);

}  // namespace mien
