#include "PictureFile.h"

#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "WholeFile.h"
#include "vtkImageData.h"
#include "vtkImageWriter.h"
#include "vtkJPEGWriter.h"
#include "vtkPNGWriter.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFWriter.h"

namespace mien {

namespace {

vtkSmartPointer<vtkImageWriter> writerFor(const std::string& ending) {
  if (ending == "png") return vtkSmartPointer<vtkPNGWriter>::New();
  if (ending == "tif" || ending == "tiff") return vtkSmartPointer<vtkTIFFWriter>::New();
  auto writer = vtkSmartPointer<vtkJPEGWriter>::New();
  writer->SetQuality(95);
  return writer;
}

bool canHold(const std::string& ending, int type) {
  if (type == VTK_UNSIGNED_CHAR) return true;
  if (ending == "png") return type == VTK_UNSIGNED_SHORT;
  return (ending == "tif" || ending == "tiff") && (type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT);
}

}  // namespace

void writePicture(vtkImageData* image, const OutputFile& file) {
  const std::string& name = file.name();
  const std::string ending = fileEnding(name);
  if (!canHold(ending, image->GetScalarType()))
    throw ValueFailure(name + ": ." + ending + " cannot hold values of this kind (" + image->GetScalarTypeAsString() +
                       "); write a .tif");
  const auto writer = writerFor(ending);
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetFileName(file.temporaryName().c_str());
  writer->SetInputData(image);
  writer->Write();
  if (!errors.first().empty()) throw FileFailure(name + ": " + WholeFile::unwritable);
}

void writePicture(vtkImageData* image, const std::string& name) {
  requireEnding(name, {"png", "jpg", "jpeg", "tif", "tiff"});
  OutputFile file(name);
  writePicture(image, file);
  file.commit();
}

}  // namespace mien
