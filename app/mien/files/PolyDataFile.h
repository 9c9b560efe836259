#pragma once

#include <string>

class vtkPolyData;

namespace mien {

/// Writes a .vtp file; a FileFailure when that is not possible.
void writePolyData(vtkPolyData* data, const std::string& name);

}  // namespace mien
