#include "vtkFDTWriter.h"

#include <vtksys/FStream.hxx>

#include "FDTData.h"
#include "PackedTable.h"
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
  if (this->Bits != 0 && this->Bits != 8 && this->Bits != 16) {
    vtkErrorMacro("there are no tables of " << this->Bits << " bits; give 0 (text), 8 or 16");
    return;
  }
  vtksys::ofstream file(name.c_str(), std::ios::binary);
  file << (this->Bits == 0 ? mien::writeTable(table, this->Comment) : mien::packTable(table, this->Bits)) << std::flush;
  if (!file)
    vtkErrorMacro(<< name << ": it cannot be written; give a file in a folder that exists and may be written to");
}

void vtkFDTWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Bits: " << this->Bits << "\n";
  os << indent << "Comment: " << this->Comment << "\n";
}
