#pragma once

#include <string>

class vtkPolyData;

namespace mien {

/// Writes boundary curves as .vtp under a temporary name and renames it.
/// @return nothing, or one sentence that says which file cannot be written and what to do; it is then as it was
std::string writeCurveFile(vtkPolyData* curves, const std::string& name);

}  // namespace mien
