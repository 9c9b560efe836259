#include "SampleOutliers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mien {

namespace {

constexpr std::size_t neighbours = 6, fewestOfRegion = 5;
constexpr double leastDifference = 0.3;  // pupil units
constexpr double robustDeviations = 6.0;
constexpr std::size_t mostSamples = 20'000;  // meshes beyond it have no markers to mistake

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// The nearest samples among candidates.
std::vector<int> nearestTo(const TableSamples& samples, int sample, std::vector<int> candidates) {
  candidates.erase(std::find(candidates.begin(), candidates.end(), sample));
  const auto distance = [&](int i) { return (samples.before.row(i) - samples.before.row(sample)).squaredNorm(); };
  const std::size_t count = std::min(neighbours, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + count, candidates.end(),
                    [&](int a, int b) { return distance(a) < distance(b); });
  candidates.resize(count);
  return candidates;
}

Eigen::Vector2d medianMove(const TableSamples& samples, const std::vector<int>& rows) {
  std::vector<double> x, y;
  for (const int i : rows) {
    const Eigen::Vector2d move = samples.after.row(i) - samples.before.row(i);
    x.push_back(move.x());
    y.push_back(move.y());
  }
  return {medianOf(x), medianOf(y)};
}

}  // namespace

std::vector<SampleOutlier> sampleOutliers(const TableSamples& samples) {
  const int count = static_cast<int>(samples.regions.size());
  if (count <= int(neighbours) || samples.regions.size() > mostSamples) return {};
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> regions(FacialRegions::count + 1);
  for (int i = 0; i < count; ++i) regions[samples.regions[i]].push_back(i);
  std::vector<SampleOutlier> outliers;
  std::vector<double> differences;
  for (int i = 0; i < count; ++i) {
    const std::vector<int>& own = regions[samples.regions[i]];
    const std::vector<int> near = nearestTo(samples, i, own.size() < fewestOfRegion ? all : own);
    const Eigen::Vector2d move = samples.after.row(i) - samples.before.row(i);
    differences.push_back((move - medianMove(samples, near)).norm());
    if (differences.back() > leastDifference) outliers.push_back({i, differences.back()});
  }
  const double limit = robustDeviations * 1.4826 * medianOf(differences);
  outliers.erase(std::remove_if(outliers.begin(), outliers.end(), [&](const auto& o) { return o.difference <= limit; }),
                 outliers.end());
  std::sort(outliers.begin(), outliers.end(), [](const auto& a, const auto& b) { return a.difference > b.difference; });
  return outliers;
}

}  // namespace mien
