#include "vtkScanReader.h"

#include "MeshData.h"
#include "ScanFile.h"
#include "SurfaceMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkScanReader);

vtkScanReader::vtkScanReader() {
  this->SetNumberOfInputPorts(0);
}

vtkScanReader::~vtkScanReader() {
  this->SetFileName(nullptr);
}

int vtkScanReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkScanReader::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  const std::string name = this->FileName ? this->FileName : "";
  mien::MeshText scan;
  const std::string fault =
      name.empty() ? "FileName is not set; give a scan of a head" : mien::readScanFile(name, scan);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeTriangleMesh(scan.mesh, vtkPolyData::GetData(outputs));
  return 1;
}

void vtkScanReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
