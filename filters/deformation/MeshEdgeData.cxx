#include "MeshEdgeData.h"

#include <Eigen/Geometry>

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

namespace mien {

namespace {

/// Calls function(ids) for each visible cell. @return the first cell that names a point that is not there, -1 for none
template <class Function>
vtkIdType forCells(vtkPointSet* data, const Function& function) {
  vtkUnsignedCharArray* hidden = data->GetCellGhostArray();
  vtkNew<vtkIdList> ids;
  const vtkIdType points = data->GetNumberOfPoints();
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
    if (hidden && hidden->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) continue;
    data->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
      if (id < 0 || id >= points) return cell;
    function(ids);
  }
  return -1;
}

Eigen::Vector3d pointOf(vtkPointSet* data, vtkIdType id) {
  Eigen::Vector3d point;
  data->GetPoint(id, point.data());
  return point;
}

}  // namespace

std::string readEdges(vtkPointSet* data, MeshEdges& edges) {
  edges.clear();
  const vtkIdType fault = forCells(data, [&](vtkIdList* ids) {
    const vtkIdType count = ids->GetNumberOfIds();
    for (vtkIdType i = 0; count > 1 && i < (count == 2 ? 1 : count); ++i)
      edges.push_back({static_cast<int>(ids->GetId(i)), static_cast<int>(ids->GetId((i + 1) % count))});
  });
  return fault < 0 ? "" : "cell " + std::to_string(fault) + " names a point that is not there; repair the mesh";
}

std::vector<Eigen::Vector3d> polygonNormals(vtkPointSet* data) {
  std::vector<Eigen::Vector3d> normals(data->GetNumberOfPoints(), Eigen::Vector3d::Zero());
  double volume = 0.0;
  bool any = false;
  const vtkIdType fault = forCells(data, [&](vtkIdList* ids) {
    if (ids->GetNumberOfIds() < 3) return;
    any = true;
    const Eigen::Vector3d first = pointOf(data, ids->GetId(0));
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
      area += (pointOf(data, ids->GetId(i - 1)) - first).cross(pointOf(data, ids->GetId(i)) - first);
    volume += area.dot(first);
    for (const vtkIdType id : *ids) normals[id] += area;
  });
  if (!any || fault >= 0) return {};
  for (Eigen::Vector3d& normal : normals) {
    normal.stableNormalize();
    if (volume < 0.0) normal = -normal;
  }
  return normals;
}

}  // namespace mien
