#include "FDTData.h"

#include <cmath>
#include <sstream>

#include "CommaText.h"
#include "NumberText.h"
#include "TableText.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace mien {

// The text form names every column and row once; both directions go through it.
void writeFDT(const DeformationTable& table, vtkTable* data) {
  std::istringstream lines(writeTable(table));
  std::string line;
  std::getline(lines, line);
  data->Initialize();
  for (const std::string& name : splitAtCommas(line)) {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    data->AddColumn(column);
  }
  while (std::getline(lines, line)) {
    const vtkIdType row = data->InsertNextBlankRow();
    const auto cells = splitAtCommas(line);
    for (std::size_t i = 0; i < cells.size(); ++i) data->SetValue(row, i, *parseNumber(cells[i]));
  }
}

std::string readFDT(vtkTable* data, DeformationTable& table) {
  std::string text;
  for (vtkIdType column = 0; column < data->GetNumberOfColumns(); ++column)
    text += (column ? "," : "") + std::string(data->GetColumnName(column) ? data->GetColumnName(column) : "");
  for (vtkIdType row = 0; row < data->GetNumberOfRows(); ++row) {
    text += "\n";
    for (vtkIdType column = 0; column < data->GetNumberOfColumns(); ++column) {
      const vtkVariant cell = data->GetValue(row, column);
      if (column) text += ",";
      if (!cell.IsNumeric())
        text += cell.ToString();
      else if (std::isfinite(cell.ToDouble()))
        appendNumber(text, cell.ToDouble());
      else
        text += "nan";
    }
  }
  const std::string fault = parseTable(text, table);
  return fault.empty() ? "" : "table, line " + fault;
}

}  // namespace mien
