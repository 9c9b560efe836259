#include "vtkFDTReader.h"

#include "FDTData.h"
#include "TableText.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <filesystem>
#include <system_error>
#include <vtksys/FStream.hxx>

vtkStandardNewMacro(vtkFDTReader);

namespace {

// A table with deviations has about 5 kB; a file a thousand times larger is something else.
constexpr std::streamsize largestText = 5'000'000;

/// Returns nothing, or `FILE:LINE: what is wrong` (`FILE: what` for a file that cannot be read at all).
std::string readFile(const std::string& name, mien::DeformationTable& table) {
  if (name.empty()) return "there is no file name; set one with SetFileName";
  std::error_code ignored;
  vtksys::ifstream file(name.c_str(), std::ios::binary);
  if (!file || std::filesystem::is_directory(name, ignored))
    return name + ": it cannot be opened; give a .csv file that exists and may be read";
  std::string text(largestText, '\0');
  file.read(text.data(), largestText);
  if (file.gcount() == largestText) return name + ": it is too large for a facial deformation table";
  text.resize(static_cast<std::size_t>(file.gcount()));
  const std::string fault = mien::parseTable(text, table);
  return fault.empty() ? "" : name + ":" + fault;
}

}  // namespace

vtkFDTReader::vtkFDTReader() {
  this->SetNumberOfInputPorts(0);
}

vtkFDTReader::~vtkFDTReader() {
  this->SetFileName(nullptr);
}

int vtkFDTReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) {
  mien::DeformationTable table;
  const std::string fault = readFile(this->FileName ? this->FileName : "", table);
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
