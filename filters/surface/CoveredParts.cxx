#include "CoveredParts.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "FilterProgress.h"
#include "PlaceNeighbors.h"
#include "SurfaceMesh.h"
#include "vtkAppendPolyData.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr double leastShare = 0.01;  // of the places
constexpr int smoothingRounds = 60;
constexpr int smoothedRings = 15;  // of neighbours, at either side of the edge
constexpr const char* coverName = "Cover";

/// For each place its cover, 0 or 1, which becomes any number between.
using Cover = std::vector<double>;

/// Places that are joined with the first, as far as they are of its `key`.
template <class Key>
void findPart(int first, const PlaceNeighbors& neighbors, const Key& key, std::vector<bool>& taken,
              std::vector<int>& part) {
  part.assign(1, first);
  taken[first] = true;
  for (size_t i = 0; i < part.size(); ++i)
    for (const auto& [next, weight] : neighbors.around(part[i])) {
      if (taken[next] || key(next) != key(first)) continue;
      taken[next] = true;
      part.push_back(next);
    }
}

/// How many places are joined with each, itself among them.
std::vector<int> sizesOfComponents(const PlaceNeighbors& neighbors) {
  std::vector<int> sizes(static_cast<size_t>(neighbors.count())), part;
  std::vector<bool> taken(sizes.size());
  for (int i = 0; i < neighbors.count(); ++i) {
    if (taken[i]) continue;
    findPart(
        i, neighbors, [](int) { return 0; }, taken, part);
    for (int place : part) sizes[place] = static_cast<int>(part.size());
  }
  return sizes;
}

/// A part turns over that is small, both of the surface and of what it is joined with: a loose eye, or a triangle of a
/// soup, has nothing around it as which it could count.
void turnSmallParts(const PlaceNeighbors& neighbors, const std::vector<int>& components, double value, Cover& cover) {
  std::vector<bool> taken(cover.size());
  std::vector<int> part;
  for (int i = 0; i < neighbors.count(); ++i) {
    if (taken[i] || cover[i] != value) continue;
    findPart(
        i, neighbors, [&](int place) { return cover[place]; }, taken, part);
    if (part.size() < leastShare * cover.size() && 2 * part.size() < static_cast<size_t>(components[i]))
      for (int place : part) cover[place] = 1.0 - value;
  }
}

/// The places around the edge; what lies further away stays whole.
std::vector<int> nearEdge(const PlaceNeighbors& neighbors, const Cover& cover) {
  std::vector<int> near;
  std::vector<bool> taken(cover.size());
  for (int i = 0; i < neighbors.count(); ++i) {
    const auto differs = [&](const PlaceNeighbors::Neighbor& next) { return cover[next.place] != cover[i]; };
    const PlaceNeighbors::Range around = neighbors.around(i);
    if (!std::any_of(around.begin(), around.end(), differs)) continue;
    taken[i] = true;
    near.push_back(i);
  }
  for (size_t ring = 0, begin = 0; ring < smoothedRings; ++ring)
    for (const size_t end = near.size(); begin < end; ++begin)
      for (const auto& [next, weight] : neighbors.around(near[begin])) {
        if (taken[next]) continue;
        taken[next] = true;
        near.push_back(next);
      }
  return near;
}

double meanAround(int place, const PlaceNeighbors& neighbors, const Cover& cover) {
  double sum = 0.0, weights = 0.0;
  for (const auto& [next, weight] : neighbors.around(place)) {
    sum += weight * cover[next];
    weights += weight;
  }
  return sum / weights;
}

bool smoothen(const PlaceNeighbors& neighbors, Cover& cover, const Progress& progress) {
  const std::vector<int> near = nearEdge(neighbors, cover);
  std::vector<double> means(near.size());
  for (int round = 0; round < smoothingRounds; ++round) {
    if (!goesOn(progress, double(round) / smoothingRounds)) return false;
    for (size_t i = 0; i < near.size(); ++i) means[i] = 0.5 * (cover[near[i]] + meanAround(near[i], neighbors, cover));
    for (size_t i = 0; i < near.size(); ++i) cover[near[i]] = means[i];
  }
  return true;
}

/// Both parts of a clipped surface have the points of both.
vtkSmartPointer<vtkPolyData> withUsedPoints(vtkPolyData* part) {
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(part);
  clean->PointMergingOff();
  clean->Update();
  return clean->GetOutput();
}

bool isCounted(vtkDataArray* cover, vtkIdType point) {
  return cover->GetComponent(point, 0) >= 0.5;
}

/// Of all points that do not count.
void takeNumbers(vtkPolyData* surface) {
  vtkPointData* data = surface->GetPointData();
  vtkDataArray* cover = data->GetArray(coverName);
  for (const char* name : {"Distance", "DistanceVector"}) {
    vtkDataArray* array = data->GetArray(name);
    if (!array) continue;
    const auto rest = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());  // the surface keeps its own
    rest->DeepCopy(array);
    const double none = array->GetNumberOfComponents() == 1 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
    for (vtkIdType i = 0; i < rest->GetNumberOfTuples(); ++i)
      for (int k = 0; k < rest->GetNumberOfComponents() && !isCounted(cover, i); ++k) rest->SetComponent(i, k, none);
    data->AddArray(rest);
  }
}

/// Cells with corners on both sides of the edge.
std::vector<bool> cellsOnEdge(vtkPolyData* surface) {
  vtkDataArray* cover = surface->GetPointData()->GetArray(coverName);
  std::vector<bool> onEdge(static_cast<size_t>(surface->GetNumberOfCells()));
  vtkNew<vtkIdList> corners;
  for (size_t cell = 0; cell < onEdge.size(); ++cell) {
    surface->GetCellPoints(static_cast<vtkIdType>(cell), corners);
    for (vtkIdType i = 1; i < corners->GetNumberOfIds(); ++i)
      if (isCounted(cover, corners->GetId(i)) != isCounted(cover, corners->GetId(0))) onEdge[cell] = true;
  }
  return onEdge;
}

/// The other cells, over the same points.
vtkSmartPointer<vtkPolyData> wholeCells(vtkPolyData* surface, const std::vector<bool>& onEdge) {
  const auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->SetPoints(surface->GetPoints());
  whole->GetPointData()->ShallowCopy(surface->GetPointData());
  whole->AllocateCopy(surface);
  whole->GetCellData()->CopyAllocate(surface->GetCellData(), surface->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell) {
    if (onEdge[cell]) continue;
    surface->GetCellPoints(cell, corners);
    const vtkIdType copy = whole->InsertNextCell(surface->GetCellType(cell), corners);
    whole->GetCellData()->CopyData(surface->GetCellData(), cell, copy);
  }
  takeNumbers(whole);
  return whole;
}

vtkSmartPointer<vtkPolyData> edgeCells(vtkPolyData* surface, const std::vector<bool>& onEdge) {
  vtkNew<vtkIdList> cells;
  for (size_t cell = 0; cell < onEdge.size(); ++cell)
    if (onEdge[cell]) cells->InsertNextId(static_cast<vtkIdType>(cell));
  const auto edge = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  edge->SetPoints(points);
  edge->AllocateEstimate(std::max<vtkIdType>(1, cells->GetNumberOfIds()), 4);
  edge->GetPointData()->CopyAllocate(surface->GetPointData());
  edge->GetCellData()->CopyAllocate(surface->GetCellData());
  edge->CopyCells(surface, cells);
  edge->GetPointData()->SetActiveScalars(coverName);
  return edge;
}

/// The points of the edge are in both parts, and count in one.
vtkSmartPointer<vtkPolyData> restOf(vtkPolyData* clipped) {
  const auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->ShallowCopy(clipped);
  vtkNew<vtkDoubleArray> none;
  none->SetName(coverName);
  none->SetNumberOfTuples(rest->GetNumberOfPoints());
  none->Fill(0.0);
  rest->GetPointData()->SetScalars(none);
  takeNumbers(rest);
  return rest;
}

vtkSmartPointer<vtkPolyData> withCover(vtkPolyData* surface, const PlaceNeighbors& neighbors, const Cover& cover) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(coverName);
  values->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    values->SetValue(i, cover[neighbors.placeOf(static_cast<int>(i))]);
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(surface);
  copy->GetPointData()->SetScalars(values);
  return copy;
}

/// The cells stay wound as they are. Few are on the edge: the others are not asked to be clipped, which takes long.
vtkSmartPointer<vtkPolyData> cut(vtkPolyData* surface, const Progress& progress) {
  const std::vector<bool> onEdge = cellsOnEdge(surface);
  if (!goesOn(progress, 0.2)) return nullptr;
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(edgeCells(surface, onEdge));
  clip->SetValue(0.5);
  clip->GenerateClippedOutputOn();
  if (!updateWith(partOf(progress, 0.3, 0.4), clip)) return nullptr;
  const auto counted = withUsedPoints(clip->GetOutput()), rest = withUsedPoints(clip->GetClippedOutput());
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(wholeCells(surface, onEdge));
  both->AddInputData(counted);
  both->AddInputData(restOf(rest));
  if (!updateWith(partOf(progress, 0.8, 1.0), both)) return nullptr;
  both->GetOutput()->GetPointData()->RemoveArray(coverName);
  return both->GetOutput();
}

}  // namespace

vtkSmartPointer<vtkPolyData> coveredApart(vtkPolyData* surface, const Progress& progress) {
  vtkDataArray* covered = surface->GetPointData()->GetArray("Covered");
  if (!covered) return surface;
  if (!goesOn(progress, 0.0)) return nullptr;
  const PlaceNeighbors neighbors(meshOf(trianglesOf(surface)), partOf(progress, 0.2, 0.5));
  Cover cover(static_cast<size_t>(neighbors.count()));
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    if (covered->GetComponent(i, 0) != 0.0) cover[neighbors.placeOf(static_cast<int>(i))] = 1.0;
  if (!goesOn(progress, 0.5)) return nullptr;
  const std::vector<int> components = sizesOfComponents(neighbors);
  for (double value : {0.0, 1.0}) turnSmallParts(neighbors, components, value, cover);
  if (std::all_of(cover.begin(), cover.end(), [](double value) { return value == 1.0; })) return surface;
  if (!smoothen(neighbors, cover, partOf(progress, 0.55, 0.7))) return nullptr;
  return cut(withCover(surface, neighbors, cover), partOf(progress, 0.7, 1.0));
}

}  // namespace mien
