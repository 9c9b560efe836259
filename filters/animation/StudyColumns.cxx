#include "StudyColumns.h"

#include <limits>

#include "NumberText.h"
#include "Study.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace mien {

namespace {

double numberIn(const std::string& cell) {
  return parseNumber(cell).value_or(std::numeric_limits<double>::quiet_NaN());
}

void append(const std::string& cell, vtkStringArray* column) {
  column->InsertNextValue(cell);
}

void append(const std::string& cell, vtkDoubleArray* column) {
  column->InsertNextValue(numberIn(cell));
}

void append(const std::string& cell, vtkIntArray* column) {
  column->InsertNextValue(static_cast<int>(numberIn(cell)));
}

void append(const std::string& cell, vtkIdTypeArray* column) {
  column->InsertNextValue(static_cast<vtkIdType>(numberIn(cell)));
}

/// Takes the cells of one column after the other.
class Columns {
 public:
  Columns(const std::vector<std::vector<std::string>>& rows, vtkTable* table) : rows_(rows), table_(table) {
    table->Initialize();
  }

  template <class Array>
  void add(const std::string& name) {
    vtkNew<Array> column;
    column->SetName(name.c_str());
    for (const std::vector<std::string>& row : rows_) append(row[taken_], column.Get());
    table_->AddColumn(column);
    ++taken_;
  }

 private:
  const std::vector<std::vector<std::string>>& rows_;
  vtkTable* table_;
  std::size_t taken_ = 0;
};

}  // namespace

void writeStudyColumns(const Study& study, const std::vector<std::vector<std::string>>& rows, vtkTable* table) {
  Columns columns(rows, table);
  columns.add<vtkIdTypeArray>("case");
  for (const char* const name : {"id", "face", "scheme"}) columns.add<vtkStringArray>(name);
  columns.add<vtkDoubleArray>("a");
  columns.add<vtkIntArray>("harmonics");
  columns.add<vtkStringArray>("expression");
  columns.add<vtkDoubleArray>("frame");
  for (const std::string& measure : study.measures) columns.add<vtkDoubleArray>(measure);
  columns.add<vtkStringArray>("reason");
}

}  // namespace mien
