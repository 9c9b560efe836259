#pragma once

#include <string>

class vtkPolyData;

namespace mien {

/// The points of a surface or of curves as CSV: x, y, z in mm and every point array, one column a component
/// ("Displacement_x"). Empty without points.
std::string pointNumbers(vtkPolyData* points);

}  // namespace mien
