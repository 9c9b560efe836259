#include "ImageFile.h"

#include "PipelineErrors.h"

#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFReader.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <system_error>

namespace mien {

namespace {

constexpr int largestSide = 32768;           // pixels
constexpr std::int64_t largestRatio = 2000;  // of bytes in memory to bytes in the file; zlib reaches 1032, JPEG 512

/// The reader by the file's ending, told apart whatever the case of its letters.
vtkSmartPointer<vtkImageReader2> readerFor(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (ending == ".png") return vtkSmartPointer<vtkPNGReader>::New();
  if (ending == ".jpg" || ending == ".jpeg") return vtkSmartPointer<vtkJPEGReader>::New();
  if (ending != ".tif" && ending != ".tiff") return nullptr;
  auto reader = vtkSmartPointer<vtkTIFFReader>::New();
  reader->SetOrientationType(4);  // rows of the file from the top, as most are; the reader flips them
  return reader;
}

/// A head that promises more than the file can hold is not believed, before memory is taken for it.
std::string describeSizeFault(vtkImageReader2* reader, std::int64_t bytes) {
  const int* extent = reader->GetDataExtent();
  const std::int64_t width = extent[1] - extent[0] + std::int64_t(1), height = extent[3] - extent[2] + std::int64_t(1);
  if (width < 1 || height < 1) return "there is no picture in it";
  if (width > largestSide || height > largestSide)
    return "it has " + std::to_string(width) + " x " + std::to_string(height) + " pixels; at most " + std::to_string(largestSide) +
           " along a side are read";
  if (width * height > largestRatio * bytes) return "it is too short for its " + std::to_string(width) + " x " + std::to_string(height) + " pixels; it is damaged or cut off";
  return {};
}

std::string read(const std::string& name, vtkImageData* image) {
  std::error_code missing;
  const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(name, missing));
  if (missing || bytes == 0) return "it cannot be opened; give a picture that exists and may be read";
  const auto reader = readerFor(name);
  if (!reader) return "its ending is none of .png, .jpg, .jpeg, .tif and .tiff";
  PipelineErrors errors;
  errors.observe(reader);
  if (reader->CanReadFile(name.c_str()) == 0) return "it is no picture of the kind that its ending says";
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  const std::string fault = errors.first().empty() ? describeSizeFault(reader, bytes) : "";
  if (!fault.empty()) return fault;
  if (errors.first().empty()) reader->Update();
  const bool empty = reader->GetOutput()->GetNumberOfPoints() == 0 || !reader->GetOutput()->GetPointData()->GetScalars();
  if (!errors.first().empty() || reader->GetErrorCode() != 0 || empty) return "it is damaged or cut off";
  image->ShallowCopy(reader->GetOutput());
  return {};
}

}  // namespace

std::string readImageFile(const std::string& name, vtkImageData* image) {
  image->Initialize();
  const std::string fault = read(name, image);
  return fault.empty() ? "" : name + ": " + fault;
}

}  // namespace mien
