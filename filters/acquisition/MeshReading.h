#pragma once

#include <string>

#include "MienAcquisitionModule.h"
#include "vtkSmartPointer.h"

class vtkDataObject;

namespace mien {

/// Reads a surface: .vts (vtkStructuredGrid), .vtp, .ply, .obj, .stl or .off (vtkPolyData), lengths as in the file.
/// @return nothing, or one sentence that says what is wrong with the file; `surface` is then as it was
MIENACQUISITION_EXPORT std::string readSurfaceFile(const std::string& name, vtkSmartPointer<vtkDataObject>& surface);

/// Whether the name ends as one of these.
MIENACQUISITION_EXPORT bool isSurfaceFile(const std::string& name);

}  // namespace mien
