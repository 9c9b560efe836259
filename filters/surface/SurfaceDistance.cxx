#include "SurfaceDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkTriangle.h"

namespace mien {

namespace {

using Vector = std::array<double, 3>;

/// Share of a corner below which the nearest point counts as lying on the opposite edge.
constexpr double onEdge = 1e-9;

Vector difference(const double* a, const double* b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Angle at corner i of a triangle.
double cornerAngle(const double points[3][3], int i) {
  const Vector one = difference(points[(i + 1) % 3], points[i]), other = difference(points[(i + 2) % 3], points[i]);
  return vtkMath::AngleBetweenVectors(one.data(), other.data());
}

/// Shares of the corners of a triangle in a point of it.
Vector cornerShares(const double corners[3][3], const double* point) {
  Vector shares, normal;
  double part[3];
  vtkTriangle::ComputeNormalDirection(corners[0], corners[1], corners[2], normal.data());
  const double squared = vtkMath::Dot(normal, normal);
  for (int i = 0; i < 3; ++i) {
    vtkTriangle::ComputeNormalDirection(point, corners[(i + 1) % 3], corners[(i + 2) % 3], part);
    shares[i] = squared > 0.0 ? vtkMath::Dot(part, normal.data()) / squared : 1.0 / 3.0;
  }
  return shares;
}

/// The distance that a share of the area does not exceed; distances with their areas, sorted.
double quantile(const std::vector<std::pair<double, double>>& sorted, double area) {
  double sum = 0.0;
  for (const auto& [distance, part] : sorted)
    if ((sum += part) >= area) return distance;
  return sorted.empty() ? 0.0 : sorted.back().first;
}

}  // namespace

struct SurfaceDistance::Internals {
  vtkSmartPointer<vtkPolyData> triangles;
  vtkNew<vtkStaticCellLocator> locator;
  std::vector<std::array<vtkIdType, 3>> corners;
  std::vector<Vector> faceNormals;
  std::vector<Vector> cornerNormals;

  void fillNormals() {
    faceNormals.resize(triangles->GetNumberOfCells());
    cornerNormals.assign(triangles->GetNumberOfPoints(), {0, 0, 0});
    for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell) {
      double points[3][3];
      this->readCorners(cell, points);
      vtkTriangle::ComputeNormal(points[0], points[1], points[2], faceNormals[cell].data());
      for (int i = 0; i < 3; ++i)
        for (int xyz = 0; xyz < 3; ++xyz)
          cornerNormals[corners[cell][i]][xyz] += cornerAngle(points, i) * faceNormals[cell][xyz];
    }
  }

  /// Read once: the cell array's own access is not safe in threads.
  void fillTriangles() {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell) {
      triangles->GetCellPoints(cell, ids);
      corners.push_back({ids->GetId(0), ids->GetId(1), ids->GetId(2)});
    }
  }

  void readCorners(vtkIdType cell, double points[3][3]) const {
    for (int i = 0; i < 3; ++i) triangles->GetPoint(corners[cell][i], points[i]);
  }

  /// The direction that is outside at a point of a triangle.
  Vector outside(vtkIdType cell, const double* point) const {
    double points[3][3];
    this->readCorners(cell, points);
    const std::array<vtkIdType, 3>& ids = corners[cell];
    const Vector shares = cornerShares(points, point);
    const int absent =
        static_cast<int>(std::count_if(shares.begin(), shares.end(), [](double s) { return s < onEdge; }));
    const int nearest = static_cast<int>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    const int farthest = static_cast<int>(std::min_element(shares.begin(), shares.end()) - shares.begin());
    if (absent == 0) return faceNormals[cell];
    if (absent >= 2) return cornerNormals[ids[nearest]];
    return this->edgeNormal(cell, ids[(farthest + 1) % 3], ids[(farthest + 2) % 3]);
  }

  Vector edgeNormal(vtkIdType cell, vtkIdType begin, vtkIdType end) const {
    thread_local vtkNew<vtkIdList> others;
    triangles->GetCellEdgeNeighbors(cell, begin, end, others);
    Vector sum = faceNormals[cell];
    for (vtkIdType i = 0; i < others->GetNumberOfIds(); ++i)
      for (int xyz = 0; xyz < 3; ++xyz) sum[xyz] += faceNormals[others->GetId(i)][xyz];
    return sum;
  }
};

SurfaceDistance::SurfaceDistance(vtkPolyData* triangles) : Impl(new Internals) {
  this->Impl->triangles = triangles;
  triangles->BuildLinks();
  triangles->ComputeBounds();
  this->Impl->fillTriangles();
  this->Impl->fillNormals();
  this->Impl->locator->SetDataSet(triangles);
  this->Impl->locator->BuildLocator();
}

SurfaceDistance::~SurfaceDistance() = default;

double SurfaceDistance::operator()(const double point[3], bool withSign, double nearest[3]) const {
  double closest[3], squared = 0.0;
  vtkIdType cell = -1;
  int part = 0;
  thread_local vtkNew<vtkGenericCell> found;
  this->Impl->locator->FindClosestPoint(point, closest, found, cell, part, squared);
  const double distance = std::sqrt(squared);
  if (nearest) std::copy(closest, closest + 3, nearest);
  if (!withSign || cell < 0) return distance;
  const Vector away = difference(point, closest), outside = this->Impl->outside(cell, closest);
  return vtkMath::Dot(away, outside) < 0.0 ? -distance : distance;
}

DistanceSummary summarize(const std::vector<double>& distances, const std::vector<double>& areas,
                          const std::function<bool(size_t)>& counts) {
  DistanceSummary summary;
  std::vector<std::pair<double, double>> sorted;
  for (size_t i = 0; i < distances.size(); ++i) {
    if (!counts(i)) continue;
    const double distance = std::abs(distances[i]);
    summary.rms += areas[i] * distance * distance;
    summary.mean += areas[i] * distance;
    summary.maximum = std::max(summary.maximum, distance);
    summary.area += areas[i];
    ++summary.points;
    sorted.emplace_back(distance, areas[i]);
  }
  if (summary.area > 0.0) {
    summary.rms = std::sqrt(summary.rms / summary.area);
    summary.mean /= summary.area;
    std::sort(sorted.begin(), sorted.end());
    summary.median = quantile(sorted, 0.5 * summary.area);
    summary.percentile95 = quantile(sorted, 0.95 * summary.area);
  }
  return summary;
}

}  // namespace mien
