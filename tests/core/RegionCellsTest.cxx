#include <gtest/gtest.h>

#include <random>

#include "RegionCells.h"
#include "RegionMap.h"

using namespace mien;

namespace {

double area(const PlanePolygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return 0.5 * twice;
}

bool inside(const PlanePolygon& convex, const Eigen::Vector2d& point) {
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Eigen::Vector2d &p = convex[i], d = convex[(i + 1) % convex.size()] - p;
    if (d.x() * (point.y() - p.y()) - d.y() * (point.x() - p.x()) < 0.0) return false;
  }
  return !convex.empty();
}

}  // namespace

TEST(RegionCells, FillTheOutlineWithoutGaps) {
  const FacialRegions regions = regionMap();
  double sum = 0.0;
  for (const PlanePolygon& cell : regionCells(regions)) {
    EXPECT_GT(area(cell), 0.05);
    sum += area(cell);
  }
  EXPECT_NEAR(sum, area(faceOutline(regions)), 1e-9);
  for (const Eigen::Vector2d& point : faceOutline(regions)) EXPECT_NEAR(regions.outlineWeight(point), 0.5, 1e-6);
}

TEST(RegionCells, HoldThePointsOfTheirRegion) {
  const FacialRegions regions = regionMap();
  const std::vector<PlanePolygon> cells = regionCells(regions);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-2.3, 2.3), y(-3.8, 1.8);
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d point(x(random), y(random));
    if (regions.outlineWeight(point) < 0.6) continue;
    EXPECT_TRUE(inside(cells[regions.nearest(point) - 1], point)) << point.transpose();
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(DeformationTable, WeightedTablesAddTheirDisplacements) {
  DeformationTable a, b;
  a.maps[3].coefficients(0, 5) = 0.2;
  a.maps[3].coefficients(1, 4) = 1.4;
  b.maps[3].coefficients(0, 5) = -0.1;
  a.largestDisplacement = 0.2;
  b.largestDisplacement = 0.1;
  const DeformationTable sum = DeformationTable::weighted({{a, 0.5}, {b, 2.0}});
  EXPECT_NEAR(sum.maps[3].coefficients(0, 5), -0.1, 1e-15);
  EXPECT_NEAR(sum.maps[3].coefficients(1, 4), 1.2, 1e-15);
  EXPECT_EQ(sum.maps[0].coefficients, QuadraticMap::identity());
  EXPECT_NEAR(sum.largestDisplacement, 0.3, 1e-15);
  const DeformationTable mixed = DeformationTable::weighted({{a, 0.3}, {b, 0.7}}), blended = a.blended(b, 0.7);
  EXPECT_LT((mixed.maps[3].coefficients - blended.maps[3].coefficients).norm(), 1e-15);
  a.deviations.emplace();
  EXPECT_TRUE(DeformationTable::weighted({{a, 1.0}}).deviations);
  EXPECT_FALSE(DeformationTable::weighted({{a, 0.5}}).deviations);
}
