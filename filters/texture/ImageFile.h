#pragma once

#include <string>

#include "MienTextureModule.h"

class vtkImageData;

namespace mien {

/// Reads a picture: .png, .jpg, .jpeg, .tif or .tiff of 8 or 16 bits or float.
/// Rows are taken as they are stored, from the top; a turn noted beside them (EXIF) is not followed.
/// @return nothing, or `FILE: what is wrong and what to do`; the image is then empty
MIENTEXTURE_EXPORT std::string readImageFile(const std::string& name, vtkImageData* image);

}  // namespace mien
