#include "WarpMeshData.h"

#include <algorithm>

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"

namespace mien {

namespace {

constexpr const char* sizeName = "ImageSize";
constexpr const char* pointName = "PointName";

}  // namespace

std::string readWarpMesh(vtkStructuredGrid* data, WarpMesh& mesh) {
  vtkDataArray* size = data ? data->GetFieldData()->GetArray(sizeName) : nullptr;
  if (!size || size->GetNumberOfTuples() < 2)
    return "the mesh has no field array ImageSize of two values; it says how large the image of the mesh is";
  const int columns = data->GetDimensions()[0], rows = data->GetDimensions()[1];
  if (data->GetNumberOfPoints() != static_cast<vtkIdType>(rows) * columns)
    return "the mesh is no plane grid of rows and columns";
  WarpMesh read(rows, columns, size->GetTuple1(0), size->GetTuple1(1));
  auto* names = vtkStringArray::SafeDownCast(data->GetPointData()->GetAbstractArray(pointName));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const vtkIdType id = static_cast<vtkIdType>(i) * columns + j;
      const double* point = data->GetPoint(id);
      read.x(i, j) = point[0] + 0.5;
      read.y(i, j) = read.height - 0.5 - point[1];
      if (names) read.names.push_back(names->GetValue(id));
    }
  mesh = std::move(read);
  return {};
}

void writeWarpMesh(const WarpMesh& mesh, vtkStructuredGrid* data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < mesh.rows(); ++i)
    for (int j = 0; j < mesh.columns(); ++j)
      points->InsertNextPoint(mesh.x(i, j) - 0.5, mesh.height - 0.5 - mesh.y(i, j), 0.0);
  vtkNew<vtkDoubleArray> size;
  size->SetName(sizeName);
  size->InsertNextValue(mesh.width);
  size->InsertNextValue(mesh.height);
  data->Initialize();
  data->SetDimensions(mesh.columns(), mesh.rows(), 1);
  data->SetPoints(points);
  data->GetFieldData()->AddArray(size);
  if (mesh.names.empty()) return;
  vtkNew<vtkStringArray> names;
  names->SetName(pointName);
  for (const std::string& name : mesh.names) names->InsertNextValue(name);
  data->GetPointData()->AddArray(names);
}

}  // namespace mien
