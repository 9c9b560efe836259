#include "CsvTable.h"

#include <vtkDataArray.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <sstream>

namespace mien {

namespace {

constexpr int digits = 10;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (char letter : text) result += letter == '"' ? "\"\"" : std::string(1, letter);
  return result + "\"";
}

}  // namespace

std::string tableText(vtkTable* table) {
  std::ostringstream text;
  text.precision(digits);
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
    text << (column ? "," : "") << quoted(table->GetColumnName(column));
  text << "\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row) {
    for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column) {
      text << (column ? "," : "");
      const auto* numbers = vtkDataArray::SafeDownCast(table->GetColumn(column));
      numbers ? text << const_cast<vtkDataArray*>(numbers)->GetTuple1(row)
              : text << quoted(table->GetValue(row, column).ToString());
    }
    text << "\n";
  }
  return text.str();
}

}  // namespace mien
