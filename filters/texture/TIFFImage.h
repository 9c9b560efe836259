#pragma once

#include <string>

class vtkImageData;

namespace mien {

/// Whether VTK's reader takes a .tif as it is: grey, or RGB of 8 bits, not packed as JPEG. Of others it takes one
/// channel, half of the rows or no alpha, without a word.
bool isPlainTIFF(const std::string& name);

/// Any .tif that libtiff knows, as 8 bits: CMYK, palettes, 16 bits a channel, alpha, JPEG inside.
/// @param image  unsigned char, 3 or with alpha 4 components; the first line is at the bottom
/// @return whether it could be read whole
bool readTIFF(const std::string& name, vtkImageData* image);

}  // namespace mien
