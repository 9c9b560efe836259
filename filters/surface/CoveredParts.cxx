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
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace mien {

namespace {

constexpr double leastShare = 0.01;  // of the points
constexpr int smoothingRounds = 40;
constexpr const char* coverName = "Cover";

using Neighbors = std::vector<std::vector<vtkIdType>>;

Neighbors neighborsIn(vtkPolyData* triangles) {
  Neighbors neighbors(triangles->GetNumberOfPoints());
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell) {
    triangles->GetCellPoints(cell, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
        if (i != k) neighbors[corners->GetId(i)].push_back(corners->GetId(k));
  }
  return neighbors;
}

/// All points of one value that are joined with the first.
std::vector<vtkIdType> partAround(vtkIdType first, const Neighbors& neighbors, const std::vector<double>& cover,
                                  std::vector<bool>& taken) {
  std::vector<vtkIdType> part = {first};
  taken[first] = true;
  for (size_t i = 0; i < part.size(); ++i)
    for (vtkIdType next : neighbors[part[i]]) {
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

void smoothen(const Neighbors& neighbors, std::vector<double>& cover) {
  for (int round = 0; round < smoothingRounds; ++round) {
    const std::vector<double> before = cover;
    for (size_t i = 0; i < cover.size(); ++i) {
      if (neighbors[i].empty()) continue;
      double sum = 0.0;
      for (vtkIdType next : neighbors[i]) sum += before[next];
      cover[i] = 0.5 * (before[i] + sum / neighbors[i].size());
    }
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
