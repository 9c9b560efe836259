#pragma once

#include <QImage>

class vtkImageData;

namespace mien {

/// An image of unsigned char with 3 or 4 components as a picture for the screen.
QImage pictureOf(vtkImageData* image);

}  // namespace mien
