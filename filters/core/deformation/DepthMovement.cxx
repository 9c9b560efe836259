#include "DepthMovement.h"

#include <cmath>

namespace mien {

namespace {

double rootMean(double sum, long count) {
  return count ? std::sqrt(sum / count) : 0.0;
}

}  // namespace

DepthMovement::DepthMovement(const NormalisedPoints& before, const NormalisedPoints& after, const FacialRegions& map) {
  std::array<double, FacialRegions::count> sums{};
  std::array<long, FacialRegions::count> counts{};
  double sum = 0.0;
  long count = 0;
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const DeformationPoint& point = before.points[i];
    const Eigen::Vector3d place = before.pupils.apply(point.position);
    if (!isFitted(map, place, point)) continue;
    const double depth = after.pupils.apply(after.points[i].position).z() - place.z();
    const int region = map.nearest(place.head<2>(), point.side) - 1;
    sums[region] += depth * depth;
    ++counts[region];
    sum += depth * depth;
    ++count;
  }
  for (int i = 0; i < FacialRegions::count; ++i) regions[i] = rootMean(sums[i], counts[i]);
  all = rootMean(sum, count);
}

}  // namespace mien
