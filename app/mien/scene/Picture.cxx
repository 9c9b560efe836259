#include "Picture.h"

#include <algorithm>
#include <array>

#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "WholeFile.h"
#include "vtkImageData.h"
#include "vtkImageExtractComponents.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"

namespace mien {

namespace {

using Pixel = std::array<unsigned char, 4>;

/// Of the block of pixels that becomes one.
Pixel meanPixel(const unsigned char* block, vtkIdType stride, int factor) {
  int weighted[3] = {0, 0, 0}, opacity = 0;
  for (int y = 0; y < factor; ++y)
    for (int x = 0; x < factor; ++x) {
      const unsigned char* pixel = block + y * stride + 4 * x;
      for (int c = 0; c < 3; ++c) weighted[c] += pixel[c] * pixel[3];
      opacity += pixel[3];
    }
  Pixel mean{};
  for (int c = 0; c < 3 && opacity > 0; ++c)
    mean[c] = static_cast<unsigned char>((weighted[c] + opacity / 2) / opacity);
  mean[3] = static_cast<unsigned char>((opacity + factor * factor / 2) / (factor * factor));
  return mean;
}

}  // namespace

vtkSmartPointer<vtkImageData> reduced(vtkImageData* image, int factor) {
  int size[3];
  image->GetDimensions(size);
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(size[0] / factor, size[1] / factor, 1);
  result->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto* from = static_cast<const unsigned char*>(image->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(result->GetScalarPointer());
  const vtkIdType stride = 4 * static_cast<vtkIdType>(size[0]);
  for (int y = 0; y < size[1] / factor; ++y)
    for (int x = 0; x < size[0] / factor; ++x) {
      const Pixel mean = meanPixel(from + y * factor * stride + 4 * static_cast<vtkIdType>(x) * factor, stride, factor);
      to = std::copy(mean.begin(), mean.end(), to);
    }
  return result;
}

vtkSmartPointer<vtkImageData> opaque(vtkImageData* image) {
  vtkNew<vtkImageExtractComponents> colours;
  colours->SetInputData(image);
  colours->SetComponents(0, 1, 2);
  colours->Update();
  return colours->GetOutput();
}

void writePNG(vtkImageData* image, const std::string& name, const std::map<std::string, std::string>& texts) {
  OutputFile file(name);
  vtkNew<vtkPNGWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  for (const auto& [key, text] : texts) writer->AddText(key.c_str(), text.c_str());
  writer->SetFileName(file.temporaryName().c_str());
  writer->SetInputData(image);
  writer->Write();
  if (!errors.first().empty()) throw FileFailure(name + ": " + WholeFile::unwritable);
  file.commit();
}

}  // namespace mien
