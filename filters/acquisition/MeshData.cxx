#include "MeshData.h"

#include <vector>

#include "RadialSkin.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

std::vector<Eigen::Vector3i> fanTriangles(vtkCellArray* polygons) {
  std::vector<Eigen::Vector3i> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell) {
    polygons->GetCellAtId(cell, ids);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
      triangles.emplace_back(static_cast<int>(ids->GetId(0)), static_cast<int>(ids->GetId(i - 1)),
                             static_cast<int>(ids->GetId(i)));
  }
  return triangles;
}

}  // namespace

std::string readTriangleMesh(vtkPolyData* data, TriangleMesh& mesh) {
  if (!data || !data->GetPoints()) return "there is no mesh; give a scan of a head's surface";
  const std::vector<Eigen::Vector3i> triangles = fanTriangles(data->GetPolys());
  TriangleMesh read;
  read.vertices.resize(data->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i) data->GetPoint(i, read.vertices.row(i).data());
  read.triangles.resize(static_cast<int>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) read.triangles.row(static_cast<int>(i)) = triangles[i];
  const std::string fault = describeFault(read);
  if (fault.empty()) mesh = std::move(read);
  return fault;
}

void writeTriangleMesh(const TriangleMesh& mesh, vtkPolyData* data) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.vertices.rows());
  for (vtkIdType i = 0; i < mesh.vertices.rows(); ++i) points->SetPoint(i, mesh.vertices.row(i).data());
  vtkNew<vtkCellArray> polygons;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const vtkIdType ids[3] = {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)};
    polygons->InsertNextCell(3, ids);
  }
  data->Initialize();
  data->SetPoints(points);
  data->SetPolys(polygons);
}

}  // namespace mien
