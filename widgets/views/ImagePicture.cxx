#include "ImagePicture.h"

#include <vtkImageData.h>

namespace mien {

QImage pictureOf(vtkImageData* image) {
  const int* size = image->GetDimensions();
  const int channels = image->GetNumberOfScalarComponents();
  if (size[0] < 1 || size[1] < 1 || image->GetScalarType() != VTK_UNSIGNED_CHAR || channels < 3) return {};
  const auto* pixels = static_cast<const uchar*>(image->GetScalarPointer());
  const QImage::Format format = channels == 3 ? QImage::Format_RGB888 : QImage::Format_RGBA8888;
  return QImage(pixels, size[0], size[1], static_cast<qsizetype>(size[0]) * channels, format).mirrored();
}

}  // namespace mien
