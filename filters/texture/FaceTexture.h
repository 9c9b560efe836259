#pragma once

#include <string>

#include "FaceState.h"
#include "MienTextureModule.h"

class vtkImageData;
class vtkPolyData;

namespace mien {

/// The warp mesh that lies beside a photograph: its name with .csv for its ending.
MIENTEXTURE_EXPORT std::string meshBeside(const std::string& imageFile);

/// The texture of a face: the photograph and the source mesh of the state, warped onto the (u, v) of the face with
/// these neutral boundary curves [S 4.2], 2048 x 1024 pixels. The photograph spans the frontal half of v; around the
/// back its edge colours go over into each other.
/// @param texture  unsigned char, 3 or 4 components; for a surface with `TextureCoordinates`
/// @return nothing, or one sentence that says which file is at fault and why
MIENTEXTURE_EXPORT std::string makeFaceTexture(const FaceState& state, vtkPolyData* curves, vtkImageData* texture);

}  // namespace mien
