#include "SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOrderedGeometryFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataConnectivityFilter.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkTriangle.h"
#include "vtkTriangleFilter.h"

namespace mien {

namespace {

/// Calls function(ids) with the three point ids of each triangle.
template <class Function>
void forTriangles(vtkPolyData* triangles, const Function& function) {
  vtkNew<vtkIdList> ids;
  vtkCellArray* cells = triangles->GetPolys();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    cells->GetCellAtId(cell, ids);
    function(ids->GetPointer(0));
  }
}

/// Whether the triangles face against the point normals, summed over all of them.
bool facesAgainstNormals(vtkPolyData* triangles) {
  vtkDataArray* normals = triangles->GetPointData()->GetNormals();
  if (!normals) return false;
  double sum = 0.0;
  forTriangles(triangles, [&](const vtkIdType* ids) {
    double points[3][3], normal[3];
    for (int i = 0; i < 3; ++i) triangles->GetPoint(ids[i], points[i]);
    vtkTriangle::ComputeNormalDirection(points[0], points[1], points[2], normal);
    sum += vtkMath::Dot(normal, normals->GetTuple3(ids[0]));
  });
  return sum < 0.0;
}

std::string describeIdFault(const char* kind, vtkCellArray* cells, vtkIdType pointCount, const std::string& name) {
  if (!cells->IsValid())
    return "the " + std::string(kind) + " of the " + name +
           " have offsets that do not fit their point ids; export the mesh again";
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
    cells->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
      if (id < 0 || id >= pointCount)
        return "cell " + std::to_string(cell) + " of the " + kind + " of the " + name + " uses point " +
               std::to_string(id) + " of " + std::to_string(pointCount) + "; export the mesh again";
  }
  return {};
}

std::string describeLengthFault(vtkFieldData* arrays, vtkIdType expected, const std::string& name) {
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != expected)
      return "array " + std::string(array->GetName() ? array->GetName() : "without a name") + " of the " + name +
             " has " + std::to_string(array->GetNumberOfTuples()) + " values where " + std::to_string(expected) +
             " are needed; export the mesh again";
  }
  return {};
}

void reverse(vtkPolyData* triangles) {
  vtkNew<vtkCellArray> reversed;
  forTriangles(triangles, [&](const vtkIdType* ids) {
    const vtkIdType other[3] = {ids[2], ids[1], ids[0]};
    reversed->InsertNextCell(3, other);
  });
  triangles->SetPolys(reversed);
}

}  // namespace

void requestWhole(vtkInformation* input) {
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!input) return;
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  if (input->Has(Pipeline::WHOLE_EXTENT()))
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
}

vtkInformation* askedOutput(vtkInformation* request, vtkInformationVector* outputs) {
  const bool isOne = request && request->Has(vtkExecutive::FROM_OUTPUT_PORT());
  return outputs->GetInformationObject(isOne ? std::max(request->Get(vtkExecutive::FROM_OUTPUT_PORT()), 0) : 0);
}

bool isLaterPiece(vtkInformation* request, vtkInformationVector* outputs) {
  return askedOutput(request, outputs)->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0;
}

void offerGrid(vtkInformation* output, int rows, int columns) {
  const int extent[6] = {0, columns, 0, rows - 1, 0, 0};
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  output->Remove(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST());  // that of the curves: it would leave pieces to the filter
}

vtkSmartPointer<vtkPolyData> visibleSurface(vtkDataObject* data) {
  if (auto* surface = vtkPolyData::SafeDownCast(data)) return surface;
  if (!vtkStructuredGrid::SafeDownCast(data)) return nullptr;
  vtkNew<vtkOrderedGeometryFilter> geometry;
  geometry->SetInputData(data);
  geometry->Update();
  return geometry->GetOutput();
}

vtkSmartPointer<vtkPolyData> largestComponent(vtkPolyData* surface) {
  vtkNew<vtkPolyDataConnectivityFilter> connectivity;
  connectivity->SetInputData(surface);
  connectivity->SetExtractionModeToLargestRegion();
  connectivity->Update();
  return connectivity->GetOutput();
}

vtkSmartPointer<vtkPolyData> trianglesOf(vtkPolyData* surface) {
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(surface);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  const auto triangles = vtkSmartPointer<vtkPolyData>::New();
  triangles->SetPoints(triangulate->GetOutput()->GetPoints());
  triangles->SetPolys(triangulate->GetOutput()->GetPolys());
  triangles->GetPointData()->SetNormals(surface->GetPointData()->GetNormals());
  if (facesAgainstNormals(triangles)) reverse(triangles);
  return triangles;
}

std::string describeMeshFault(vtkPolyData* mesh, const std::string& name) {
  const vtkIdType points = mesh->GetNumberOfPoints();
  const std::pair<const char*, vtkCellArray*> kinds[] = {{"vertices", mesh->GetVerts()},
                                                         {"lines", mesh->GetLines()},
                                                         {"polygons", mesh->GetPolys()},
                                                         {"strips", mesh->GetStrips()}};
  std::string fault;
  for (const auto& [kind, cells] : kinds)
    if (fault.empty()) fault = describeIdFault(kind, cells, points, name);
  if (fault.empty()) fault = describeLengthFault(mesh->GetPointData(), points, name);
  if (fault.empty()) fault = describeLengthFault(mesh->GetCellData(), mesh->GetNumberOfCells(), name);
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (fault.empty() && normals && normals->GetNumberOfComponents() != 3)
    fault = "the normals of the " + name + " do not have 3 components; export the mesh again";
  return fault;
}

std::string readSurface(vtkDataObject* data, const std::string& name, bool largestOnly, SurfaceMesh& mesh) {
  const auto surface = visibleSurface(data);
  std::string fault = surface ? describeMeshFault(surface, name) : describeFault(nullptr, name);
  if (!fault.empty()) return fault;
  mesh.surface = largestOnly ? largestComponent(surface) : surface;
  mesh.triangles = trianglesOf(mesh.surface);
  return describeFault(mesh.triangles, name);
}

std::string describeFault(vtkPolyData* triangles, const std::string& name) {
  if (!triangles || triangles->GetNumberOfPolys() == 0) return "the " + name + " has no polygons; give a surface mesh";
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i)
    for (int xyz = 0; xyz < 3; ++xyz)
      if (!std::isfinite(triangles->GetPoint(i)[xyz]))
        return "point " + std::to_string(i) + " of the " + name + " is not finite; repair the mesh";
  const std::vector<double> areas = pointAreas(triangles);
  if (!(std::accumulate(areas.begin(), areas.end(), 0.0) > 0.0))
    return "the " + name + " has no area, all its polygons are degenerate; give a surface mesh";
  return {};
}

std::vector<double> pointAreas(vtkPolyData* triangles) {
  std::vector<double> areas(triangles->GetNumberOfPoints(), 0.0);
  forTriangles(triangles, [&](const vtkIdType* ids) {
    double points[3][3];
    for (int i = 0; i < 3; ++i) triangles->GetPoint(ids[i], points[i]);
    const double third = vtkTriangle::TriangleArea(points[0], points[1], points[2]) / 3.0;
    for (int i = 0; i < 3; ++i) areas[ids[i]] += third;
  });
  return areas;
}

TriangleMesh meshOf(vtkPolyData* triangles) {
  TriangleMesh mesh;
  mesh.vertices.resize(triangles->GetNumberOfPoints(), 3);
  for (vtkIdType i = 0; i < triangles->GetNumberOfPoints(); ++i) triangles->GetPoint(i, mesh.vertices.row(i).data());
  mesh.triangles.resize(triangles->GetNumberOfPolys(), 3);
  Eigen::Index row = 0;
  forTriangles(triangles, [&](const vtkIdType* ids) {
    for (int i = 0; i < 3; ++i) mesh.triangles(row, i) = static_cast<int>(ids[i]);
    ++row;
  });
  return mesh;
}

}  // namespace mien
