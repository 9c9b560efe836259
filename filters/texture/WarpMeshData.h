#pragma once

#include <string>

#include "MienTextureModule.h"
#include "WarpMesh.h"

class vtkStructuredGrid;

/// Warp meshes as VTK data and as the mathematics sees them.
///
/// As vtkStructuredGrid of columns x rows x 1 points, rows from top to bottom, in the coordinates of an image of
/// spacing 1 and origin 0, so that the mesh lies on its image: the middle of pixel (i, j) is (i, j, 0), y up. Field
/// array `ImageSize` (width, height in pixels), point array `PointName` (string), empty for points without a name.
namespace mien {

/// @return nothing, or one sentence that says what is wrong; whether the mesh is folded is not looked at
MIENTEXTURE_EXPORT std::string readWarpMesh(vtkStructuredGrid* data, WarpMesh& mesh);

/// Makes the grid hold this mesh, as described above.
MIENTEXTURE_EXPORT void writeWarpMesh(const WarpMesh& mesh, vtkStructuredGrid* data);

}  // namespace mien
