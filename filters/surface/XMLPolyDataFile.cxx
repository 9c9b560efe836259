#include "XMLPolyDataFile.h"

#include "PipelineErrors.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

namespace mien {

bool fillPolyData(vtkPolyData* data, const std::string& name) {
  vtkNew<vtkXMLPolyDataWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetFileName(name.c_str());
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->SetCompressorTypeToNone();
  return writer->Write() == 1 && errors.first().empty() && writer->GetErrorCode() == 0;
}

}  // namespace mien
