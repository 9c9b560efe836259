#include "PolyDataFile.h"

#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "WholeFile.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

namespace mien {

void writePolyData(vtkPolyData* data, const std::string& name) {
  OutputFile file(name);
  vtkNew<vtkXMLPolyDataWriter> writer;
  PipelineErrors errors;
  errors.observe(writer);
  writer->SetFileName(file.temporaryName().c_str());
  writer->SetDataModeToBinary();
  writer->SetInputDataObject(data);
  if (!writer->Write() || !errors.first().empty()) throw FileFailure(name + ": " + WholeFile::unwritable);
  file.commit();
}

}  // namespace mien
