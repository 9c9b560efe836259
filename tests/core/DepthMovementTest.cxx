#include <gtest/gtest.h>

#include "DepthMovement.h"
#include "RegionMap.h"

using namespace mien;

namespace {

std::vector<DeformationPoint> centresAt(const FacialRegions& map, double z) {
  std::vector<DeformationPoint> points(FacialRegions::count);
  for (int region = 1; region <= FacialRegions::count; ++region)
    points[region - 1].position = {map.centre(region).x(), map.centre(region).y(), z};
  return points;
}

}  // namespace

TEST(DepthMovement, IsTheRootMeanSquareOfZInEachRegion) {
  const FacialRegions map = regionMap();
  PupilNormalisation pupils;
  ASSERT_EQ(pupils.set({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}), "");
  std::vector<DeformationPoint> before = centresAt(map, 0.0), after = centresAt(map, 0.0);
  after[7].position.z() = 0.3;
  after[8].position.z() = -0.4;
  before.push_back(before[7]);
  after.push_back(before[7]);
  const DepthMovement depth({before, pupils}, {after, pupils}, map);
  EXPECT_NEAR(depth.regions[7], 0.3 / std::sqrt(2.0), 1e-12) << "of two points one moves";
  EXPECT_NEAR(depth.regions[8], 0.4, 1e-12);
  EXPECT_EQ(depth.regions[0], 0.0);
  int counted = 0;
  for (const DeformationPoint& point : before) counted += map.covers(point.position.head<2>());
  EXPECT_NEAR(depth.all, std::sqrt((0.09 + 0.16) / counted), 1e-12);
}
