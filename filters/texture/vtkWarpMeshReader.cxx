#include "vtkWarpMeshReader.h"

#include "TextFileReader.h"
#include "WarpMeshData.h"
#include "WarpMeshText.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

vtkStandardNewMacro(vtkWarpMeshReader);

namespace {

// The largest warp mesh has 65,536 points and about 4 MB; a file larger than this is something else.
constexpr std::size_t largestText = 10'000'000;

std::string readFile(const char* name, mien::WarpMesh& mesh) {
  if (!name) return "there is no file name; set one with SetFileName";
  std::string text;
  const std::string unread = mien::readTextFile(name, largestText, text, "warp mesh");
  if (!unread.empty()) return name + (":" + unread);
  const std::string fault = mien::parseWarpMesh(text, mesh);
  return fault.empty() ? "" : std::string(name) + ":" + fault;
}

}  // namespace

vtkWarpMeshReader::vtkWarpMeshReader() {
  this->SetNumberOfInputPorts(0);
}

vtkWarpMeshReader::~vtkWarpMeshReader() {
  this->SetFileName(nullptr);
}

int vtkWarpMeshReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  mien::WarpMesh mesh;
  const std::string fault = readFile(this->FileName, mesh);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  const int extent[6] = {0, mesh.columns() - 1, 0, mesh.rows() - 1, 0, 0};
  outputs->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkWarpMeshReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  mien::WarpMesh mesh;
  const std::string fault = readFile(this->FileName, mesh);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeWarpMesh(mesh, vtkStructuredGrid::GetData(outputs));
  return 1;
}

void vtkWarpMeshReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
