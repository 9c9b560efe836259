#include "vtkFDTReader.h"

#include "FDTData.h"
#include "NamedTables.h"
#include "SurfaceMesh.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTReader);

vtkFDTReader::vtkFDTReader() {
  this->SetNumberOfInputPorts(0);
}

vtkFDTReader::~vtkFDTReader() {
  this->SetFileName(nullptr);
}

int vtkFDTReader::RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  outputs->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkFDTReader::RequestData(vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs) {
  if (mien::isLaterPiece(request, outputs)) return 1;
  mien::DeformationTable table;
  const std::string name = this->FileName ? this->FileName : "";
  const std::string fault =
      name.empty() ? "there is no file name; set one with SetFileName" : mien::readNamedTable(name, table);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return 0;
  }
  mien::writeFDT(table, vtkTable::GetData(outputs));
  return 1;
}

void vtkFDTReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
