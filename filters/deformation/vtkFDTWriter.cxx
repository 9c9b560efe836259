#include "vtkFDTWriter.h"

#include <vtksys/FStream.hxx>

#include "FDTData.h"
#include "TableText.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTWriter);

vtkFDTWriter::~vtkFDTWriter() {
  this->SetFileName(nullptr);
}

int vtkFDTWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

void vtkFDTWriter::WriteData() {
  mien::DeformationTable table;
  const std::string name = this->FileName ? this->FileName : "";
  const std::string fault = mien::readFDT(vtkTable::SafeDownCast(this->GetInput()), table);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return;
  }
  vtksys::ofstream file(name.c_str(), std::ios::binary);
  file << mien::writeTable(table, this->Comment) << std::flush;
  if (!file)
    vtkErrorMacro(<< name << ": it cannot be written; give a file in a folder that exists and may be written to");
}

void vtkFDTWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Comment: " << this->Comment << "\n";
}
