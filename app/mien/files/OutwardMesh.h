#pragma once

#include <string>

#include "vtkSmartPointer.h"

class vtkAlgorithm;

namespace mien {

/// The polygons of a mesh's file (MeshFile.h) as they are drawn: wound outwards, with normals of the points (those of
/// the file, else of the polygons around them). Throws a FileFailure for a file that is no mesh or has no polygons.
vtkSmartPointer<vtkAlgorithm> outwardMesh(const std::string& file);

}  // namespace mien
