#include "CurveFile.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>

#include "PipelineErrors.h"

namespace mien {

std::string writeCurveFile(vtkPolyData* curves, const std::string& file) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  const std::string part = file + ".part";
  writer->SetFileName(part.c_str());
  writer->SetInputData(curves);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  std::error_code failure;
  if (writer->Write() == 1 && errors.first().empty()) std::filesystem::rename(part, file, failure);
  if (errors.first().empty() && !failure) return {};
  std::filesystem::remove(part, failure);
  return file + ": it cannot be written; give a file in a folder that exists and may be written to";
}

}  // namespace mien
