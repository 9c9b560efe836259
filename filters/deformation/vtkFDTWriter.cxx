#include "vtkFDTWriter.h"

#include <filesystem>
#include <system_error>
#include <vtksys/FStream.hxx>

#include "FDTData.h"
#include "PackedTable.h"
#include "TableText.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTWriter);

namespace {

/// Writes under a temporary name beside the file and renames it, so that what was there is replaced whole or not at
/// all.
/// @return nothing, or what is wrong
std::string writeWhole(const std::string& name, const std::string& bytes) {
  const std::string temporary = name + ".part";
  std::error_code fault;
  {
    vtksys::ofstream file(temporary.c_str(), std::ios::binary);
    file << bytes << std::flush;
    if (!file) fault = std::make_error_code(std::errc::io_error);
  }
  if (!fault) std::filesystem::rename(temporary, name, fault);
  if (!fault) return {};
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  return "it cannot be written; give a file in a folder that exists and may be written to";
}

}  // namespace

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
    fault =
        writeWhole(name, this->Bits == 0 ? mien::writeTable(table, this->Comment) : mien::packTable(table, this->Bits));
  if (!fault.empty()) vtkErrorMacro(<< name << ": " << fault);
}

void vtkFDTWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Bits: " << this->Bits << "\n";
  os << indent << "Comment: " << this->Comment << "\n";
}
