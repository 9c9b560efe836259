#include "MeshEdgeData.h"

#include <Eigen/Geometry>

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

namespace mien {

namespace {

/// Calls function(ids) for each visible cell until it says stop. @return the first cell that names a point that is not
/// there, -1 for none
template <class Function>
vtkIdType forCells(vtkPointSet* data, const Function& function) {
  vtkUnsignedCharArray* hidden = data->GetCellGhostArray();
  if (hidden && hidden->GetNumberOfTuples() != data->GetNumberOfCells()) hidden = nullptr;
  vtkNew<vtkIdList> ids;
  const vtkIdType points = data->GetNumberOfPoints();
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell) {
    if (hidden && hidden->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL) continue;
    data->GetCellPoints(cell, ids);
    for (const vtkIdType id : *ids)
      if (id < 0 || id >= points) return cell;
    if (!function(ids)) break;
  }
  return -1;
}

}  // namespace

std::string readEdges(vtkPointSet* data, MeshEdges& edges) {
  edges.clear();
  const vtkIdType fault = forCells(data, [&](vtkIdList* ids) {
    const vtkIdType count = ids->GetNumberOfIds();
    for (vtkIdType i = 0; count > 1 && i < (count == 2 ? 1 : count); ++i)
      edges.push_back({static_cast<int>(ids->GetId(i)), static_cast<int>(ids->GetId((i + 1) % count))});
    return true;
  });
  return fault < 0 ? "" : "cell " + std::to_string(fault) + " names a point that is not there; repair the mesh";
}

bool hasPolygons(vtkPointSet* data) {
  bool found = false;
  forCells(data, [&](vtkIdList* ids) { return !(found = ids->GetNumberOfIds() > 2); });
  return found;
}

MeshPolygons::MeshPolygons(vtkPointSet* data) : starts_{0} {
  const vtkIdType fault = forCells(data, [&](vtkIdList* ids) {
    if (ids->GetNumberOfIds() < 3) return true;
    corners_.insert(corners_.end(), ids->begin(), ids->end());
    starts_.push_back(static_cast<vtkIdType>(corners_.size()));
    return true;
  });
  if (fault >= 0) *this = MeshPolygons();
}

std::vector<Eigen::Vector3d> MeshPolygons::normals(vtkPoints* points) const {
  if (empty()) return {};
  std::vector<Eigen::Vector3d> places(points->GetNumberOfPoints());
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    points->GetPoint(static_cast<vtkIdType>(i), places[i].data());
    middle += places[i] / double(places.size());
  }
  std::vector<Eigen::Vector3d> normals(places.size(), Eigen::Vector3d::Zero());
  double outwards = 0.0;
  for (std::size_t polygon = 0; polygon + 1 < starts_.size(); ++polygon) {
    const vtkIdType begin = starts_[polygon], end = starts_[polygon + 1];
    const Eigen::Vector3d& first = places[corners_[begin]];
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (vtkIdType i = begin + 2; i < end; ++i)
      area += (places[corners_[i - 1]] - first).cross(places[corners_[i]] - first);
    outwards += area.dot(first - middle);
    for (vtkIdType i = begin; i < end; ++i) normals[corners_[i]] += area;
  }
  for (Eigen::Vector3d& normal : normals) {
    normal.stableNormalize();
    if (outwards < 0.0) normal = -normal;
  }
  return normals;
}

}  // namespace mien
