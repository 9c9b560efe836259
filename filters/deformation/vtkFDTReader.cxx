#include "vtkFDTReader.h"

#include "FDTData.h"
#include "TableText.h"
#include "TextFileReader.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkFDTReader);

namespace {

// A table with deviations has about 9 kB; a file hundreds of times larger is something else.
constexpr std::size_t largestText = 5'000'000;

/// Returns nothing, or `FILE:LINE: what is wrong` (`FILE: what` for a file that cannot be read at all).
std::string readFile(const std::string& name, mien::DeformationTable& table) {
  if (name.empty()) return "there is no file name; set one with SetFileName";
  std::string text;
  std::string fault = mien::readTextFile(name, largestText, text);
  if (fault.empty()) fault = mien::parseTable(text, table);
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
