#include "MeshFile.h"

#include <algorithm>
#include <filesystem>

#include "Failure.h"
#include "OutputFile.h"
#include "PipelineErrors.h"
#include "XMLDataFile.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace mien {

namespace {

vtkSmartPointer<vtkDataObject> readScan(const std::string& name) {
  vtkNew<vtkScanReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(name.c_str());
  reader->Update();
  const std::string& fault = errors.first();
  if (fault.empty()) return reader->GetOutputDataObject(0);
  throw FileFailure(fault.rfind(name, 0) == 0 ? fault : name + ": cannot be read as a surface (" + fault + ")");
}

template <class Reader>
vtkSmartPointer<vtkDataObject> readXML(const std::string& name) {
  vtkNew<Reader> reader;
  const std::string fault = readXMLDataFile(name, reader);
  if (!fault.empty()) throw FileFailure(fault);
  return reader->GetOutputDataObject(0);
}

}  // namespace

vtkSmartPointer<vtkDataObject> readMesh(const std::string& name) {
  static const std::vector<std::string> scans = {"ply", "obj", "stl", "off"};
  const std::string ending = fileEnding(name);
  const bool isScan = std::find(scans.begin(), scans.end(), ending) != scans.end();
  if (!isScan && ending != "vts" && ending != "vtp")
    throw ValueFailure("surface '" + name +
                       "' has an unknown ending; the known ones are .vts .vtp .ply .obj .stl .off");
  std::error_code error;
  if (std::filesystem::is_directory(name, error)) throw FileFailure(name + ": it is a folder; give a surface file");
  if (!std::filesystem::is_regular_file(name, error))
    throw FileFailure(name + ": there is no such file; give a surface as .vts .vtp .ply .obj .stl .off");
  if (isScan) return readScan(name);
  if (ending == "vts") return readXML<vtkXMLStructuredGridReader>(name);
  return readXML<vtkXMLPolyDataReader>(name);
}

}  // namespace mien
