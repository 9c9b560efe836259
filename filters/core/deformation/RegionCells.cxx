#include "RegionCells.h"

#include <cmath>

namespace mien {

namespace {

constexpr int directions = 180;
constexpr double beyondAnyOutline = 50.0;  // pupil units, beyond any outline a face can have

Eigen::Vector2d middleOf(const FacialRegions& regions) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int region = 1; region <= FacialRegions::count; ++region) sum += regions.centre(region);
  return sum / FacialRegions::count;
}

/// The part of a polygon where offset + normal . p <= 0.
PlanePolygon clipped(const PlanePolygon& polygon, const Eigen::Vector2d& normal, double offset) {
  PlanePolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at = normal.dot(p) + offset, next = normal.dot(q) + offset;
    if (at <= 0.0) result.push_back(p);
    if ((at < 0.0 && next > 0.0) || (at > 0.0 && next < 0.0)) result.push_back(p + at / (at - next) * (q - p));
  }
  return result;
}

}  // namespace

PlanePolygon faceOutline(const FacialRegions& regions) {
  const Eigen::Vector2d middle = middleOf(regions);
  PlanePolygon outline;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / directions;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    double inside = 0.0, outside = beyondAnyOutline;
    while (outside - inside > 1e-9) {
      const double half = 0.5 * (inside + outside);
      (regions.outlineWeight(middle + half * direction) > 0.5 ? inside : outside) = half;
    }
    outline.push_back(middle + inside * direction);
  }
  return outline;
}

std::vector<PlanePolygon> regionCells(const FacialRegions& regions) {
  std::vector<PlanePolygon> cells(FacialRegions::count, faceOutline(regions));
  for (int region = 1; region <= FacialRegions::count; ++region)
    for (int other = 1; other <= FacialRegions::count; ++other) {
      if (other == region) continue;
      const Eigen::Vector2d normal = regions.centre(other) - regions.centre(region);
      const double offset = 0.5 * (regions.centre(region).squaredNorm() - regions.centre(other).squaredNorm());
      cells[region - 1] = clipped(cells[region - 1], normal, offset);
    }
  return cells;
}

}  // namespace mien
