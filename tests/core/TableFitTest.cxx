#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "RegionMap.h"
#include "SampleOutliers.h"
#include "TableFit.h"

using namespace mien;

namespace {

Eigen::Vector3d smile(const Eigen::Vector3d& p) {
  return {p.x() + 2.0 * std::sin(p.y() / 20.0), p.y() + 3.0 * std::cos(p.x() / 30.0), p.z()};
}

/// A grid of markers over a face of pupil unit 30 mm with head movement before and after the expression.
MarkerTable gridMarkers(const Eigen::Affine3d& before, const Eigen::Affine3d& after) {
  MarkerTable table;
  const Eigen::Vector3d left(30, 0, 0), right(-30, 0, 0);
  EXPECT_EQ(table.neutral.set(before * left, before * right), "");
  EXPECT_EQ(table.expression.set(after * left, after * right), "");
  for (int x = -6; x <= 6; ++x)
    for (int y = -12; y <= 6; ++y) {
      const Eigen::Vector3d point(10.0 * x + 1.0, 10.0 * y + 0.5, 0.0);
      Marker marker;
      marker.neutral = before * point;
      marker.expression = after * smile(point);
      table.markers.push_back(marker);
    }
  return table;
}

Eigen::Affine3d movement(double angle, double scale, double x, double y) {
  return Eigen::Translation3d(x, y, 3.0) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * Eigen::Scaling(scale);
}

}  // namespace

TEST(TableFit, HeadMovementLeavesTheFitUnchanged) {
  const FacialRegions regions = regionMap();
  TableFit still, moved;
  ASSERT_EQ(still.fit(samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regions)), "");
  ASSERT_EQ(moved.fit(samplesOf(gridMarkers(movement(0.2, 1.3, 40, -7), movement(-0.15, 0.8, -20, 9)), regions)), "");
  for (int i = 0; i < 16; ++i)
    EXPECT_LT((still.table.maps[i].coefficients - moved.table.maps[i].coefficients).cwiseAbs().maxCoeff(), 1e-9)
        << i + 1;
  EXPECT_GT(still.table.largestDisplacement, 0.05);
}

TEST(TableFit, NamesRegionsWithoutPoints) {
  const FacialRegions regions = regionMap();
  MarkerTable markers = gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0));
  for (Marker& marker : markers.markers) marker.region = 3;
  markers.markers[0].region = 0;
  TableFit fit;
  EXPECT_NE(fit.fit(samplesOf(markers, regions)).find("no point lies in regions 1, 2, 4"), std::string::npos);
}

TEST(TableFit, RegionsWithoutPointsStayAsTheyAreWhenAllowed) {
  const FacialRegions regions = regionMap();
  TableSamples samples = samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regions);
  TableFit whole, without;
  ASSERT_EQ(whole.fit(samples), "");
  for (int& region : samples.regions) region = region == 1 ? 4 : region == 2 ? 5 : region;
  EXPECT_EQ(without.fit(samples, {true, true}).rfind("no point lies in regions 1, 2", 0), 0u);
  ASSERT_EQ(without.fit(samples, {false, true}), "");
  EXPECT_EQ(without.emptyRegions(), (std::vector<int>{1, 2}));
  EXPECT_EQ(without.warning().rfind("regions 1, 2 have no point and will not move", 0), 0u) << without.warning();
  for (const int region : {1, 2})
    EXPECT_EQ(without.table.maps[region - 1].coefficients, QuadraticMap::identity()) << region;
  for (const int region : {3, 9, 12, 16})
    // Fewer than twelve points: the noise, of which regions 4 and 5 have some more now, decides their ridge.
    EXPECT_LT((without.table.maps[region - 1].coefficients - whole.table.maps[region - 1].coefficients).norm(), 1e-5)
        << region;
  EXPECT_TRUE(std::isfinite(without.rms) && without.rms > 0.0);
  EXPECT_NE(TableFit().fit(TableSamples(), {false, true}), "") << "no point at all";
}

TEST(TableFit, StrictRefusesSparseRegions) {
  const FacialRegions regions = regionMap();
  TableSamples samples = samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regions);
  int kept = 0;
  for (std::size_t i = 0; i < samples.regions.size(); ++i)
    if (samples.regions[i] == 9 && ++kept > 4) samples.regions[i] = 8;
  TableFit fit;
  EXPECT_NE(fit.fit(samples, {true}).find("fewer than 6 independent points"), std::string::npos);
  EXPECT_EQ(fit.fit(samples), "");
  EXPECT_EQ(fit.regions[8].points, 4);
  const std::vector<int> sparse = fit.sparseRegions();
  EXPECT_EQ(std::count(sparse.begin(), sparse.end(), 9), 1);
}

TEST(TableFit, LipLandmarksBelongToTheirLip) {
  const FacialRegions regions = regionMap();
  MarkerTable markers;
  ASSERT_EQ(markers.neutral.set({1, 0, 0}, {-1, 0, 0}), "");
  ASSERT_EQ(markers.expression.set({1, 0, 0}, {-1, 0, 0}), "");
  for (const char* name : {"landmark62", "landmark66", "marker100"}) {
    Marker marker;
    marker.name = name;
    marker.neutral = marker.expression = {0.0, -2.25, 0.0};
    markers.markers.push_back(marker);
  }
  EXPECT_EQ(samplesOf(markers, regions).regions, (std::vector<int>{12, 13, 12}));
}

TEST(TableFit, RegionsWithoutPointsAreNotKnown) {
  const FacialRegions regions = regionMap();
  TableSamples samples = samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regions);
  TableFit whole, without;
  ASSERT_EQ(whole.fit(samples), "");
  EXPECT_FALSE(whole.table.counts);
  for (int& region : samples.regions) region = region == 1 ? 4 : region == 2 ? 5 : region;
  ASSERT_EQ(without.fit(samples, {false, true}), "");
  EXPECT_EQ(without.table.unknownRegions(), (std::vector<int>{1, 2}));
}

TEST(TableFit, WhatNoFaceReachesIsRefusedAsAMistakeOfUnits) {
  TableSamples samples = samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regionMap());
  samples.after.row(7).x() += 4.5;
  TableFit fit;
  EXPECT_NE(fit.fit(samples).find("further than any face reaches; the pupils and the points"), std::string::npos);
  samples.after.row(7).x() -= 1.0;
  EXPECT_EQ(fit.fit(samples), "");
  samples.after *= 1000.0;
  EXPECT_NE(fit.fit(samples).find("in one unit"), std::string::npos);
}

TEST(SampleOutliers, AMistakenMarkerIsFoundAndAnExpressionIsNone) {
  const TableSamples good = samplesOf(gridMarkers(movement(0, 1, 0, 0), movement(0, 1, 0, 0)), regionMap());
  EXPECT_TRUE(sampleOutliers(good).empty());
  EXPECT_TRUE(sampleOutliers(TableSamples()).empty());
  for (int row = 0; row < int(good.regions.size()); row += 9) {
    TableSamples mistaken = good;
    mistaken.after.row(row).y() += 0.5;
    const std::vector<SampleOutlier> found = sampleOutliers(mistaken);
    ASSERT_EQ(found.size(), 1u) << row;
    EXPECT_EQ(found[0].sample, row);
    EXPECT_NEAR(found[0].difference, 0.5, 0.1);
    mistaken.after.row(row).y() -= 0.25;
    EXPECT_TRUE(sampleOutliers(mistaken).empty()) << "a small difference may be a face's own";
  }
}
