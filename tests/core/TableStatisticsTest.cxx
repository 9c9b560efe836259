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
