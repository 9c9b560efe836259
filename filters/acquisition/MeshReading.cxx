#include "MeshReading.h"

#include <algorithm>
#include <filesystem>

#include "PipelineErrors.h"
#include "ScanFile.h"
#include "XMLDataFile.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkScanReader.h"
#include "vtkStructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"

namespace mien {

namespace {

const char* const endings[] = {".vts", ".vtp", ".ply", ".obj", ".stl", ".off"};

std::string readScan(const std::string& name, vtkSmartPointer<vtkDataObject>& surface) {
  vtkNew<vtkScanReader> reader;
  PipelineErrors errors;
  errors.observe(reader);
  reader->SetFileName(name.c_str());
  reader->Update();
  const std::string fault = errors.first();
  if (fault.empty()) surface = reader->GetOutputDataObject(0);
  if (fault.empty() || fault.rfind(name, 0) == 0) return fault;
  return name + ": cannot be read as a surface (" + fault + ")";
}

template <class Reader>
std::string readXML(const std::string& name, vtkSmartPointer<vtkDataObject>& surface) {
  vtkNew<Reader> reader;
  const std::string fault = readXMLDataFile(name, reader);
  if (fault.empty()) surface = reader->GetOutputDataObject(0);
  return fault;
}

}  // namespace

bool isSurfaceFile(const std::string& name) {
  return std::find(std::begin(endings), std::end(endings), endingOf(name)) != std::end(endings);
}

std::string readSurfaceFile(const std::string& name, vtkSmartPointer<vtkDataObject>& surface) {
  if (!isSurfaceFile(name)) return name + ": it has an unknown ending; surfaces are .vts .vtp .ply .obj .stl .off";
  std::error_code error;
  if (std::filesystem::is_directory(name, error)) return name + ": it is a folder; give a surface file";
  if (!std::filesystem::is_regular_file(name, error))
    return name + ": there is no such file; give a surface as .vts .vtp .ply .obj .stl .off";
  if (endingOf(name) == ".vts") return readXML<vtkXMLStructuredGridReader>(name, surface);
  return endingOf(name) == ".vtp" ? readXML<vtkXMLPolyDataReader>(name, surface) : readScan(name, surface);
}

}  // namespace mien
