#include "PointNumbers.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include "CsvTable.h"

namespace mien {

namespace {

constexpr const char* axes[] = {"x", "y", "z"};

void addColumn(vtkTable* table, const std::string& name, vtkDataArray* from, int component) {
  vtkNew<vtkDoubleArray> column;
  column->SetName(name.c_str());
  column->SetNumberOfTuples(from->GetNumberOfTuples());
  column->CopyComponent(0, from, component);
  table->AddColumn(column);
}

std::string partOf(const std::string& name, int component, int count) {
  if (count == 1) return name;
  return name + '_' + (count == 3 ? axes[component] : std::to_string(component));
}

}  // namespace

std::string pointNumbers(vtkPolyData* points) {
  if (!points || points->GetNumberOfPoints() == 0) return {};
  vtkNew<vtkTable> table;
  for (int axis = 0; axis < 3; ++axis) addColumn(table, axes[axis], points->GetPoints()->GetData(), axis);
  for (int i = 0; i < points->GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = points->GetPointData()->GetArray(i);
    if (!array || !array->GetName()) continue;
    const int count = array->GetNumberOfComponents();
    for (int component = 0; component < count; ++component)
      addColumn(table, partOf(array->GetName(), component, count), array, component);
  }
  return tableText(table);
}

}  // namespace mien
