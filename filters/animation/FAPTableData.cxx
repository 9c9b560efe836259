#include "FAPTableData.h"

#include <cmath>

#include "FAPFields.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkTable.h"

namespace mien {

namespace {

constexpr const char* loadArray = "AnimationLoad";

/// Calls visit(column name, value) for every column but those of FAP 3 .. 68; Frame is FAPFrame or const FAPFrame.
template <typename Frame, typename Visitor>
void visitHighLevelColumns(Frame& frame, Visitor&& visit) {
  visit("frame", frame.number);
  visitHighLevelFields(frame, visit);
}

std::string columnName(int fap) {
  return "FAP" + std::to_string(fap);
}

std::string readValue(vtkTable* table, const std::string& name, vtkIdType row, double& value) {
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  value = 0.0;
  if (!column) return {};
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(column);
  if (!numbers || numbers->GetNumberOfComponents() != 1)
    return "column " + name + " does not hold single numbers; give a numeric column";
  value = numbers->GetTuple1(row);
  if (!std::isfinite(value)) return "column " + name + ", row " + std::to_string(row) + " is not finite; give a number";
  return {};
}

void appendColumn(vtkTable* table, const std::string& name, double value) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}

}  // namespace

std::string readFAPFrame(vtkTable* table, vtkIdType row, FAPFrame& frame) {
  if (!table || row < 0 || row >= table->GetNumberOfRows())
    return "the FAP table has no row " + std::to_string(row) + "; a FAP frame is one row";
  FAPFrame read;
  std::string fault;
  visitHighLevelColumns(read, [&](const char* name, double& value) {
    if (fault.empty()) fault = readValue(table, name, row, value);
  });
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count && fault.empty(); ++fap) {
    double value = 0.0;
    fault = readValue(table, columnName(fap), row, value);
    read.setValue(fap, value);
  }
  if (fault.empty()) frame = read;
  return fault;
}

void writeFAPFrame(const FAPFrame& frame, vtkTable* table) {
  table->Initialize();
  visitHighLevelColumns(frame, [table](const char* name, double value) { appendColumn(table, name, value); });
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    appendColumn(table, columnName(fap), frame.value(fap));
}

int readLoadNumber(vtkTable* table) {
  vtkIntArray* numbers = vtkIntArray::SafeDownCast(table->GetFieldData()->GetArray(loadArray));
  return numbers && numbers->GetNumberOfValues() == 1 ? numbers->GetValue(0) : 0;
}

void writeLoadNumber(int number, vtkTable* table) {
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(loadArray);
  numbers->InsertNextValue(number);
  table->GetFieldData()->AddArray(numbers);
}

}  // namespace mien
