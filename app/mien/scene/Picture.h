#pragma once

#include <map>
#include <string>

#include "vtkSmartPointer.h"

class vtkImageData;

namespace mien {

/// The mean of factor x factor pixels each, weighted by their opacity, so that edges against a transparent background
/// keep their colour. @param image  unsigned char, 4 components, its size a multiple of the factor
vtkSmartPointer<vtkImageData> reduced(vtkImageData* image, int factor);

/// The same picture without its opacity.
vtkSmartPointer<vtkImageData> opaque(vtkImageData* image);

/// Writes a PNG file with text beside the picture, such as the state of the face.
void writePNG(vtkImageData* image, const std::string& name, const std::map<std::string, std::string>& texts);

}  // namespace mien
