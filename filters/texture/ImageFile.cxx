#include "ImageFile.h"

#include <png.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <vector>

#include "PipelineErrors.h"
#include "TIFFImage.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkImageReader2.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFReader.h"

namespace mien {

namespace {

constexpr int largestSide = 32768;  // pixels
// Bytes in memory to bytes in the file: zlib reaches 1032, JPEG 512, and a bit becomes a byte. Fax codes reach more,
// therefore pages of usual size are always believed.
constexpr std::int64_t largestRatio = 8 * 1100, alwaysBelieved = 64 << 20;

constexpr const char* damaged = "it is damaged or cut off";

/// The reader by the file's ending, told apart whatever the case of its letters.
vtkSmartPointer<vtkImageReader2> readerFor(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".png") return vtkSmartPointer<vtkPNGReader>::New();
  if (ending == ".jpg" || ending == ".jpeg") return vtkSmartPointer<vtkJPEGReader>::New();
  if (ending != ".tif" && ending != ".tiff") return nullptr;
  auto reader = vtkSmartPointer<vtkTIFFReader>::New();
  reader->SetOrientationType(1);  // rows as they come, from the top: in any other order packed files cannot be read
  return reader;
}

/// A head that promises more than the file can hold is not believed, before memory is taken for it.
/// @param pixelBytes  of one pixel in memory
std::string describeSizeFault(std::int64_t width, std::int64_t height, std::int64_t pixelBytes, std::int64_t bytes) {
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width < 1 || height < 1) return "there is no picture in it";
  if (width > largestSide || height > largestSide)
    return "it has " + size + "; at most " + std::to_string(largestSide) + " along a side are read";
  if (width * height * pixelBytes > std::max(alwaysBelieved, largestRatio * bytes))
    return "it is too short for its " + size + "; it is damaged or cut off";
  return {};
}

/// VTK's reader crashes on a .png that ends too soon or does not unpack; libpng itself says so.
std::string describePNGFault(const std::string& name, std::int64_t bytes) {
  png_image head{};
  head.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&head, name.c_str()) == 0) return damaged;
  if (head.format & PNG_FORMAT_FLAG_COLORMAP) head.format = PNG_FORMAT_RGBA;  // a palette, which VTK resolves
  const std::string fault = describeSizeFault(head.width, head.height, PNG_IMAGE_PIXEL_SIZE(head.format), bytes);
  bool sound = fault.empty();
  if (sound) {
    std::vector<png_byte> pixels(PNG_IMAGE_SIZE(head));
    sound = png_image_finish_read(&head, nullptr, pixels.data(), 0, nullptr) != 0;
  }
  png_image_free(&head);
  return fault.empty() && !sound ? damaged : fault;
}

std::string describeHeadFault(vtkImageReader2* reader, const std::string& name, std::int64_t bytes,
                              const PipelineErrors& errors) {
  if (reader->CanReadFile(name.c_str()) == 0) return "it is no picture of the kind that its ending says";
  const std::string fault = reader->IsA("vtkPNGReader") ? describePNGFault(name, bytes) : "";
  if (!fault.empty()) return fault;
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  if (!errors.first().empty()) return damaged;
  const int* extent = reader->GetDataExtent();
  if (extent[5] > extent[4]) return "it has several pages; save the one with the face as a file of its own";
  if (reader->IsA("vtkJPEGReader") && reader->GetNumberOfScalarComponents() == 4)
    return "it is in the colours of print (CMYK); save it in RGB";
  const std::int64_t pixelBytes =
      reader->GetNumberOfScalarComponents() * vtkDataArray::GetDataTypeSize(reader->GetDataScalarType());
  return describeSizeFault(std::int64_t(extent[1]) - extent[0] + 1, std::int64_t(extent[3]) - extent[2] + 1, pixelBytes,
                           bytes);
}

std::string read(const std::string& name, vtkImageData* image) {
  std::error_code missing;
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(name, missing));
  if (missing || bytes == 0) return "it cannot be opened; give a picture that exists and may be read";
  const auto reader = readerFor(name);
  if (!reader) return "its ending is none of .png, .jpg, .jpeg, .tif and .tiff";
  PipelineErrors errors;
  errors.observe(reader);
  const std::string fault = describeHeadFault(reader, name, bytes, errors);
  if (!fault.empty()) return fault;
  if (reader->IsA("vtkTIFFReader") && !isPlainTIFF(name)) return readTIFF(name, image) ? "" : damaged;
  reader->Update();
  vtkImageData* read = reader->GetOutput();
  if (!errors.first().empty() || reader->GetErrorCode() != 0 || read->GetNumberOfPoints() == 0 ||
      !read->GetPointData()->GetScalars())
    return damaged;
  vtkNew<vtkImageFlip> upright;
  upright->SetInputData(read);
  upright->SetFilteredAxis(1);
  if (reader->IsA("vtkTIFFReader")) upright->Update();
  image->ShallowCopy(reader->IsA("vtkTIFFReader") ? upright->GetOutput() : read);
  return {};
}

}  // namespace

std::string readImageFile(const std::string& name, vtkImageData* image) {
  image->Initialize();
  const std::string fault = read(name, image);
  return fault.empty() ? "" : name + ": " + fault;
}

}  // namespace mien
