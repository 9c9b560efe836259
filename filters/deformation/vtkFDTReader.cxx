#include "vtkFDTReader.h"

#include "FDTData.h"
#include "NamedTables.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTReader);

vtkFDTReader::vtkFDTReader() {
  this->SetNumberOfInputPorts(0);
}

vtkFDTReader::~vtkFDTReader() {
  this->SetFileName(nullptr);
}

int vtkFDTReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
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
