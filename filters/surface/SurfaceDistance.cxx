#include "SurfaceDistance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "SurfaceMesh.h"

namespace mien {

namespace {

/// The distance that a share of the area does not exceed; distances with their areas, sorted.
double quantile(const std::vector<std::pair<double, double>>& sorted, double area) {
  double sum = 0.0;
  for (const auto& [distance, part] : sorted)
    if ((sum += part) >= area) return distance;
  return sorted.empty() ? 0.0 : sorted.back().first;
}

}  // namespace

SurfaceDistance::SurfaceDistance(vtkPolyData* triangles) : mesh_(meshOf(triangles)) {}

double SurfaceDistance::operator()(const double point[3], bool withSign, double nearest[3]) const {
  const MeshDistance::Nearest found = this->nearest(point);
  if (nearest) std::copy(found.point.data(), found.point.data() + 3, nearest);
  return withSign && found.isBehind ? -found.distance : found.distance;
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
