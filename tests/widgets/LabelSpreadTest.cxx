#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "LabelSpread.h"

namespace {

TEST(LabelSpread, LabelsWithRoomStayWhereTheyAre) {
  const std::vector<double> wanted = {0.0, 2.0, 7.5};
  EXPECT_EQ(mien::spreadLabels(wanted, 2.0), wanted);
}

TEST(LabelSpread, LabelsAtOnePlaceSpreadEvenlyAroundIt) {
  EXPECT_EQ(mien::spreadLabels({5.0, 5.0, 5.0}, 1.0), (std::vector<double>{4.0, 5.0, 6.0}));
}

TEST(LabelSpread, NoOtherPlacesAreNearer) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0.0, 10.0), little(-0.05, 0.05);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> wanted(8);
    for (double& value : wanted) value = anywhere(random);
    std::sort(wanted.begin(), wanted.end());
    const std::vector<double> places = mien::spreadLabels(wanted, 1.0);
    const auto cost = [&](const std::vector<double>& at) {
      double sum = 0.0;
      for (size_t i = 0; i < at.size(); ++i) sum += (at[i] - wanted[i]) * (at[i] - wanted[i]);
      return sum;
    };
    const auto allowed = [](const std::vector<double>& at) {
      for (size_t i = 1; i < at.size(); ++i)
        if (at[i] - at[i - 1] < 1.0 - 1e-12) return false;
      return true;
    };
    ASSERT_TRUE(allowed(places));
    for (int change = 0; change < 50; ++change) {
      std::vector<double> other = places;
      for (double& place : other) place += little(random);
      if (!allowed(other)) continue;
      EXPECT_GE(cost(other), cost(places) - 1e-9);
    }
  }
}

}  // namespace
