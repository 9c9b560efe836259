#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "SeriesThinning.h"

using mien::thinnedSeries;

namespace {

std::vector<double> steps(int count) {
  std::vector<double> x(count);
  for (int i = 0; i < count; ++i) x[i] = 0.04 * i;
  return x;
}

TEST(SeriesThinning, AShortSeriesStays) {
  const std::vector<double> x = steps(40), y(x.rbegin(), x.rend());
  const auto kept = thinnedSeries(x, y, 10);
  ASSERT_EQ(kept.size(), 40u);
  for (int i = 0; i < 40; ++i) EXPECT_EQ(kept[i], std::make_pair(x[i], y[i]));
  EXPECT_TRUE(thinnedSeries({}, {}, 10).empty());
}

TEST(SeriesThinning, ALongSeriesKeepsEverySpikeAndItsEnds) {
  const std::vector<double> x = steps(30000);
  std::vector<double> y(x.size());
  for (size_t i = 0; i < y.size(); ++i) y[i] = std::sin(x[i]);
  y[12345] = 7.0;
  y[23456] = -9.0;
  const auto kept = thinnedSeries(x, y, 200);
  EXPECT_LE(kept.size(), 4u * 201u);
  EXPECT_GE(kept.size(), 400u);
  EXPECT_EQ(kept.front(), std::make_pair(x.front(), y.front()));
  EXPECT_EQ(kept.back(), std::make_pair(x.back(), y.back()));
  EXPECT_NE(std::find(kept.begin(), kept.end(), std::make_pair(x[12345], 7.0)), kept.end());
  EXPECT_NE(std::find(kept.begin(), kept.end(), std::make_pair(x[23456], -9.0)), kept.end());
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.first < b.first; }));
}

}  // namespace
