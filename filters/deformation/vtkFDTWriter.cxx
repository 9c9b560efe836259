#include "vtkFDTWriter.h"

#include "FDTData.h"
#include "PackedTable.h"
#include "TableText.h"
#include "WholeFile.h"
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
  std::string fault = mien::readFDT(vtkTable::SafeDownCast(this->GetInput()), table);
  if (!fault.empty()) {
    vtkErrorMacro(<< fault);
    return;
  }
  if (name.empty()) {
    vtkErrorMacro("there is no file name; set one with SetFileName");
    return;
  }
  if (this->Bits != 0 && this->Bits != 8 && this->Bits != 16) {
    vtkErrorMacro("there are no tables of " << this->Bits << " bits; give 0 (text), 8 or 16");
    return;
  }
  fault = this->Bits == 0 ? "" : mien::describePacking(table, this->Bits);
  if (fault.empty())
    fault = mien::WholeFile::write(
        name, this->Bits == 0 ? mien::writeTable(table, this->Comment) : mien::packTable(table, this->Bits));
  if (!fault.empty()) vtkErrorMacro(<< name << ": " << fault);
}

void vtkFDTWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Bits: " << this->Bits << "\n";
  os << indent << "Comment: " << this->Comment << "\n";
}
