#pragma once

#include <string>
#include <vector>

#include "vtkSmartPointer.h"

class vtkPointSet;
class vtkPolyData;
class vtkStructuredGrid;

namespace mien {

/// The endings that writeSurface() knows; .csv is left to SurfaceTable.
const std::vector<std::string>& surfaceEndings();

/// The visible cells of a face's grid, wound outwards: what the polygon formats hold.
vtkSmartPointer<vtkPolyData> outwardPolygons(vtkStructuredGrid* grid, bool triangles);

/// Writes a surface in the format of the file's ending. .vts keeps the grid with its hidden cells; the polygon formats
/// leave the hidden cells out and are wound outwards.
void writeSurface(vtkStructuredGrid* grid, const std::string& name);

/// The bytes of a .vts file as writeSurface() makes it, but not compressed. Made in memory and written at once a file
/// takes half the time, which counts where there are many.
std::string gridBytes(vtkStructuredGrid* grid);

/// The same for a grid or for polygons; polygons go into every format but .vts, a ValueFailure.
void writeMesh(vtkPointSet* mesh, const std::string& name);

}  // namespace mien
