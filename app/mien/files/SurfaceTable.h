#pragma once

#include <string>

#include "RowLayout.h"

class vtkStructuredGrid;

namespace mien {

/// Whether a surface is to be written as a table.
bool isTable(const std::string& name);

/// The endings that writeSurface() knows, and that of a table; any other is a ValueFailure.
void requireSurfaceOrTable(const std::string& name);

/// A PDE surface as CSV with the columns patch,u,v,x,y,z: u from 0 to 1 in the patch, v in radians, x, y, z in the unit
/// of the curves (mm for a face), each number in its shortest form that reads back the same.
///
/// Rows on a seam are listed once for each of their patches; the closing column is left out.
std::string faceTable(const RowLayout& rows, vtkStructuredGrid* grid);

/// The same of a single patch, whose number is 0.
std::string patchTable(vtkStructuredGrid* grid);

}  // namespace mien
