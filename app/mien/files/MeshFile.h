#pragma once

#include <string>

#include "vtkSmartPointer.h"

class vtkDataObject;

namespace mien {

/// A surface from a file: .vts .vtp .ply .obj .stl .off. Throws a FileFailure for a file that is none, a ValueFailure
/// for another ending.
vtkSmartPointer<vtkDataObject> readMesh(const std::string& name);

}  // namespace mien
