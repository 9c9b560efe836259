#include "TIFFImage.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "vtkImageData.h"

namespace mien {

namespace {

/// libtiff reports on the console; the one sentence our functions return is enough.
class QuietTIFF {
 public:
  QuietTIFF() : warn_(TIFFSetWarningHandler(nullptr)), fail_(TIFFSetErrorHandler(nullptr)) {}
  ~QuietTIFF() {
    TIFFSetWarningHandler(warn_);
    TIFFSetErrorHandler(fail_);
  }
  QuietTIFF(const QuietTIFF&) = delete;
  QuietTIFF& operator=(const QuietTIFF&) = delete;

 private:
  TIFFErrorHandler warn_, fail_;
};

using File = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

File open(const std::string& name) {
  return {TIFFOpen(name.c_str(), "r"), &TIFFClose};
}

std::uint16_t field(TIFF* file, std::uint32_t tag, std::uint16_t otherwise) {
  std::uint16_t value = otherwise;
  return TIFFGetFieldDefaulted(file, tag, &value) ? value : otherwise;
}

/// Whether the fourth sample is alpha that the colours are not multiplied by.
bool hasPlainAlpha(TIFF* file) {
  std::uint16_t count = 0, *kinds = nullptr;
  return TIFFGetField(file, TIFFTAG_EXTRASAMPLES, &count, &kinds) && count > 0 && kinds[0] == EXTRASAMPLE_UNASSALPHA;
}

/// libtiff multiplies by alpha, photographs are not.
unsigned char divided(std::uint32_t value, std::uint32_t alpha) {
  return static_cast<unsigned char>(alpha == 0 ? value
                                               : std::min<std::uint32_t>(255, (255 * value + alpha / 2) / alpha));
}

void fill(const std::vector<std::uint32_t>& pixels, int components, bool isMultiplied, vtkImageData* image) {
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const std::uint32_t pixel : pixels) {
    const std::uint32_t alpha = TIFFGetA(pixel);
    for (const std::uint32_t value : {TIFFGetR(pixel), TIFFGetG(pixel), TIFFGetB(pixel)})
      *out++ = isMultiplied ? divided(value, alpha) : static_cast<unsigned char>(value);
    if (components == 4) *out++ = static_cast<unsigned char>(alpha);
  }
}

}  // namespace

bool isPlainTIFF(const std::string& name) {
  const QuietTIFF quiet;
  const File file = open(name);
  if (!file) return true;  // VTK says what is wrong with it
  const int kind = field(file.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK),
            samples = field(file.get(), TIFFTAG_SAMPLESPERPIXEL, 1), bits = field(file.get(), TIFFTAG_BITSPERSAMPLE, 1),
            packing = field(file.get(), TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const bool grey = kind == PHOTOMETRIC_MINISBLACK && samples == 1 && bits >= 8;
  const bool colours = kind == PHOTOMETRIC_RGB && samples == 3 && bits == 8;
  return (grey || colours) && packing != COMPRESSION_JPEG && packing != COMPRESSION_OJPEG;
}

bool readTIFF(const std::string& name, vtkImageData* image) {
  const QuietTIFF quiet;
  const File file = open(name);
  std::uint32_t width = 0, height = 0;
  if (!file || !TIFFGetField(file.get(), TIFFTAG_IMAGEWIDTH, &width) ||
      !TIFFGetField(file.get(), TIFFTAG_IMAGELENGTH, &height))
    return false;
  std::vector<std::uint32_t> pixels(std::size_t(width) * height);
  if (!TIFFReadRGBAImageOriented(file.get(), width, height, pixels.data(), ORIENTATION_BOTLEFT, 1)) return false;
  std::uint16_t extra = 0, *kinds = nullptr;
  const bool hasAlpha = TIFFGetField(file.get(), TIFFTAG_EXTRASAMPLES, &extra, &kinds) && extra > 0;
  const int components = hasAlpha ? 4 : 3;
  image->SetDimensions(static_cast<int>(width), static_cast<int>(height), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  fill(pixels, components, hasPlainAlpha(file.get()), image);
  return true;
}

}  // namespace mien
