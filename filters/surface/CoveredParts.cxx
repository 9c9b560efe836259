#include "CoveredParts.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "SurfaceMesh.h"
#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkClipPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr double leastShare = 0.01;  // of the points
constexpr int smoothingRounds = 60;
constexpr int smoothedRings = 15;                        // of neighbours, at either side of the edge
constexpr double leastWeight = 0.01, mostWeight = 10.0;  // of neighbours: triangles may be without area
constexpr const char* coverName = "Cover";

/// Another corner of a triangle, with the cotangent of the angle opposite the edge that leads there: by such weights a
/// mean does not depend on which diagonals divide a grid of rectangles [Pinkall and Polthier 1993].
struct Neighbor {
  vtkIdType point;
  double weight;
};
using Neighbors = std::vector<std::vector<Neighbor>>;

double cotangentAt(const double at[3], const double one[3], const double other[3]) {
  double a[3], b[3], normal[3];
  vtkMath::Subtract(one, at, a);
  vtkMath::Subtract(other, at, b);
  vtkMath::Cross(a, b, normal);
  return std::clamp(vtkMath::Dot(a, b) / std::max(vtkMath::Norm(normal), 1e-300), leastWeight, mostWeight);
}

Neighbors neighborsIn(vtkPolyData* triangles) {
  Neighbors neighbors(triangles->GetNumberOfPoints());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell) {
    triangles->GetCellPoints(cell, corners);
    for (int i = 0; i < 3; ++i) {
      const vtkIdType at = corners->GetId(i), one = corners->GetId((i + 1) % 3), other = corners->GetId((i + 2) % 3);
      double places[3][3];
      triangles->GetPoint(at, places[0]);
      triangles->GetPoint(one, places[1]);
      triangles->GetPoint(other, places[2]);
      const double weight = cotangentAt(places[0], places[1], places[2]);
      neighbors[one].push_back({other, weight});
      neighbors[other].push_back({one, weight});
    }
  }
  return neighbors;
}

/// All points of one value that are joined with the first.
std::vector<vtkIdType> partAround(vtkIdType first, const Neighbors& neighbors, const std::vector<double>& cover,
                                  std::vector<bool>& taken) {
  std::vector<vtkIdType> part = {first};
  taken[first] = true;
  for (size_t i = 0; i < part.size(); ++i)
    for (const auto& [next, weight] : neighbors[part[i]]) {
      if (taken[next] || cover[next] != cover[first]) continue;
      taken[next] = true;
      part.push_back(next);
    }
  return part;
}

void turnSmallParts(const Neighbors& neighbors, double value, std::vector<double>& cover) {
  std::vector<bool> taken(cover.size());
  for (size_t i = 0; i < cover.size(); ++i) {
    if (taken[i] || cover[i] != value) continue;
    const std::vector<vtkIdType> part = partAround(static_cast<vtkIdType>(i), neighbors, cover, taken);
    if (part.size() < leastShare * cover.size())
      for (vtkIdType point : part) cover[point] = 1.0 - value;
  }
}

/// The points around the edge; what lies further away stays whole.
std::vector<vtkIdType> nearEdge(const Neighbors& neighbors, const std::vector<double>& cover) {
  std::vector<vtkIdType> near;
  std::vector<bool> taken(cover.size());
  for (size_t i = 0; i < cover.size(); ++i) {
    const auto differs = [&](const Neighbor& next) { return cover[next.point] != cover[i]; };
    if (!std::any_of(neighbors[i].begin(), neighbors[i].end(), differs)) continue;
    taken[i] = true;
    near.push_back(static_cast<vtkIdType>(i));
  }
  for (size_t ring = 0, begin = 0; ring < smoothedRings; ++ring)
    for (const size_t end = near.size(); begin < end; ++begin)
      for (const auto& [next, weight] : neighbors[near[begin]]) {
        if (taken[next]) continue;
        taken[next] = true;
        near.push_back(next);
      }
  return near;
}

void smoothen(const Neighbors& neighbors, std::vector<double>& cover) {
  const std::vector<vtkIdType> near = nearEdge(neighbors, cover);
  std::vector<double> means(near.size());
  for (int round = 0; round < smoothingRounds; ++round) {
    for (size_t i = 0; i < near.size(); ++i) {
      double sum = 0.0, weights = 0.0;
      for (const auto& [next, weight] : neighbors[near[i]]) {
        sum += weight * cover[next];
        weights += weight;
      }
      means[i] = 0.5 * (cover[near[i]] + sum / weights);
    }
    for (size_t i = 0; i < near.size(); ++i) cover[near[i]] = means[i];
  }
}

void takeNumbers(vtkPolyData* part) {
  vtkDataArray* distances = part->GetPointData()->GetArray("Distance");
  if (distances) distances->Fill(std::numeric_limits<double>::quiet_NaN());
  vtkDataArray* vectors = part->GetPointData()->GetArray("DistanceVector");
  if (vectors) vectors->Fill(0.0);
}

/// Both parts of a clipped surface have the points of both.
vtkSmartPointer<vtkPolyData> withUsedPoints(vtkPolyData* part) {
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(part);
  clean->PointMergingOff();
  clean->Update();
  return clean->GetOutput();
}

/// The cells stay wound as they are.
vtkSmartPointer<vtkPolyData> cut(vtkPolyData* surface, const std::vector<double>& cover) {
  vtkNew<vtkDoubleArray> values;
  values->SetName(coverName);
  values->SetNumberOfTuples(surface->GetNumberOfPoints());
  std::copy(cover.begin(), cover.end(), values->GetPointer(0));
  vtkNew<vtkPolyData> whole;
  whole->ShallowCopy(surface);
  whole->GetPointData()->SetScalars(values);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(whole);
  clip->SetValue(0.5);
  clip->GenerateClippedOutputOn();
  clip->Update();
  const auto counted = withUsedPoints(clip->GetOutput()), rest = withUsedPoints(clip->GetClippedOutput());
  takeNumbers(rest);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(counted);
  both->AddInputData(rest);
  both->Update();
  both->GetOutput()->GetPointData()->RemoveArray(coverName);
  return both->GetOutput();
}

}  // namespace

vtkSmartPointer<vtkPolyData> coveredApart(vtkPolyData* surface) {
  vtkDataArray* covered = surface->GetPointData()->GetArray("Covered");
  if (!covered) return surface;
  std::vector<double> cover(surface->GetNumberOfPoints());
  for (size_t i = 0; i < cover.size(); ++i) cover[i] = covered->GetComponent(static_cast<vtkIdType>(i), 0) != 0.0;
  const Neighbors neighbors = neighborsIn(trianglesOf(surface));
  for (double value : {0.0, 1.0}) turnSmallParts(neighbors, value, cover);
  if (std::all_of(cover.begin(), cover.end(), [](double value) { return value == 1.0; })) return surface;
  smoothen(neighbors, cover);
  return cut(surface, cover);
}

}  // namespace mien
