#include "VectorTable.h"

#include <algorithm>

#include "VectorPicture.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

json parameter(const std::vector<double>& values, int index) {
  return values.empty() ? json(nullptr) : json(values[index]);
}

void addParameter(const char* name, const std::vector<double>& values, const std::vector<int>& chosen,
                  vtkPolyData* data) {
  if (values.empty()) return;
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const int i : chosen) array->InsertNextValue(values[i]);
  data->GetPointData()->AddArray(array);
}

}  // namespace

json vectorSummary(const MotionField& field, const std::vector<int>& chosen) {
  const Eigen::VectorXd magnitudes = field.magnitudes();
  int moving = 0, largest = -1;
  double sum = 0.0;
  for (const int i : chosen) {
    moving += magnitudes[i] > leastMotion;
    sum += magnitudes[i];
    if (largest < 0 || magnitudes[i] > magnitudes[largest]) largest = i;
  }
  json about = {{"vectors", chosen.size()}, {"moving", moving}};
  about["largest_mm"] = largest < 0 ? json(nullptr) : json(magnitudes[largest]);
  about["mean_mm"] = chosen.empty() ? json(nullptr) : json(sum / chosen.size());
  if (largest >= 0)
    about["largest_at"] = {{"u", parameter(field.u, largest)},
                           {"v", parameter(field.v, largest)},
                           {"x", field.origins(largest, 0)},
                           {"y", field.origins(largest, 1)},
                           {"z", field.origins(largest, 2)}};
  return about;
}

vtkSmartPointer<vtkPolyData> chosenVectors(vtkPolyData* vectors, const MotionField& field,
                                           const std::vector<int>& chosen) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  data->GetPointData()->CopyAllocate(vectors->GetPointData(), chosen.size());
  for (const int i : chosen) {
    const vtkIdType point = points->InsertNextPoint(vectors->GetPoint(field.ids[i]));
    vertices->InsertNextCell(1, &point);
    data->GetPointData()->CopyData(vectors->GetPointData(), field.ids[i], point);
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  addParameter("u", field.u, chosen, data);
  addParameter("v", field.v, chosen, data);
  return data;
}

}  // namespace mien
