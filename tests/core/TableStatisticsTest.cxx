#include <gtest/gtest.h>

#include "TableStatistics.h"

using namespace mien;

namespace {

DeformationTable shifted(double shift) {
  DeformationTable table;
  for (QuadraticMap& map : table.maps) map.coefficients(1, 5) = shift;
  table.largestDisplacement = std::abs(shift);
  return table;
}

}  // namespace

TEST(TableStatistics, MeanAndDeviation) {
  const DeformationTable mean = meanTable({shifted(0.1), shifted(0.2), shifted(0.6)});
  EXPECT_NEAR(mean.maps[7].coefficients(1, 5), 0.3, 1e-15);
  EXPECT_NEAR(mean.deviations->at(7)(1, 5), std::sqrt((0.04 + 0.01 + 0.09) / 2.0), 1e-15);
  EXPECT_EQ(mean.deviations->at(7)(0, 3), 0.0);
  EXPECT_EQ(mean.largestDisplacement, 0.6);
  EXPECT_FALSE(meanTable({shifted(0.1)}).deviations) << "one table says nothing about deviations";
  DeformationTable unknown = shifted(0.1);
  unknown.largestDisplacement = 0.0;
  EXPECT_EQ(meanTable({shifted(0.6), unknown}).largestDisplacement, 0.0) << "the unknown one may be larger";
}

TEST(TableStatistics, TellsWhatIsOutsideTheRange) {
  const DeformationTable mean = meanTable({shifted(0.1), shifted(0.3)});
  EXPECT_TRUE(outsideRange(shifted(0.3), mean).empty());
  const std::vector<int> outside = outsideRange(shifted(0.4), mean);
  ASSERT_EQ(outside.size(), 16u);
  EXPECT_EQ(outside[2], 2 * 12 + 11);
}

/// A region at rest has deviations of rounding; what differs by no more is not outside.
TEST(TableStatistics, RoundingIsWithinTheRange) {
  const DeformationTable mean = meanTable({shifted(0.0), shifted(1e-22)});
  EXPECT_TRUE(outsideRange(shifted(4e-22), mean).empty());
  EXPECT_TRUE(outsideRange(shifted(0.0049), mean).empty());
  EXPECT_EQ(outsideRange(shifted(0.0051), mean).size(), 16u);
  EXPECT_EQ(sideOfRange(shifted(-0.0051), mean, 7, 11), -1);
  EXPECT_EQ(sideOfRange(shifted(0.0051), mean, 7, 11), 1);
  EXPECT_EQ(sideOfRange(shifted(0.0051), mean, 7, 10), 0);
}

TEST(TableStatistics, RegionsThatWereNotSeenDoNotCountAsStill) {
  DeformationTable seen = shifted(0.2), partly = shifted(0.4), blind = shifted(0.6);
  partly.counts.emplace().fill(1);
  blind.counts.emplace().fill(1);
  for (const int region : {1, 2}) partly.counts->at(region - 1) = 0;
  blind.counts->at(0) = 0;
  for (DeformationTable* table : {&partly, &blind})
    for (const int region : table->unknownRegions()) table->maps[region - 1] = QuadraticMap();
  const DeformationTable mean = meanTable({seen, partly, blind});
  EXPECT_EQ(mean.counts->at(0), 1);
  EXPECT_EQ(mean.counts->at(1), 2);
  EXPECT_EQ(mean.counts->at(2), 3);
  EXPECT_NEAR(mean.maps[0].coefficients(1, 5), 0.2, 1e-15) << "not a third of it";
  EXPECT_NEAR(mean.maps[1].coefficients(1, 5), 0.4, 1e-15);
  EXPECT_NEAR(mean.maps[2].coefficients(1, 5), 0.4, 1e-15);
  EXPECT_NEAR(mean.deviations->at(1)(1, 5), std::sqrt(0.08), 1e-15);
  EXPECT_FALSE(mean.hasRange(1)) << "one recording has no spread";
  for (const int i : outsideRange(shifted(5.0), mean)) EXPECT_GE(i, 12);
  EXPECT_EQ(outsideRange(shifted(5.0), mean).size(), 15u);
  EXPECT_EQ(outsideRange(partly, meanTable({shifted(5.0), shifted(6.0)})).size(), 14u);
  EXPECT_EQ(meanTable({blind, blind}).unknownRegions(), std::vector<int>{1}) << "nobody saw it";
}

TEST(TableStatistics, SumsKnowWhatOneOfTheirTablesKnows) {
  DeformationTable left = shifted(0.2), right = shifted(0.4);
  left.counts.emplace().fill(1);
  right.counts.emplace().fill(1);
  left.counts->at(0) = right.counts->at(0) = left.counts->at(4) = 0;
  EXPECT_EQ(DeformationTable::weighted({{left, 0.5}, {right, 0.5}}).unknownRegions(), std::vector<int>{1});
  EXPECT_EQ(left.blended(right, 0.5).unknownRegions(), std::vector<int>{1});
  EXPECT_EQ(DeformationTable::weighted({{left, 1.0}}).unknownRegions(), (std::vector<int>{1, 5}));
}
