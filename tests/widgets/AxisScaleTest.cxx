#include <gtest/gtest.h>

#include <limits>

#include "AxisScale.h"

namespace {

using mien::AxisScale;
using mien::ChartAxis;
using mien::tickText;

std::vector<std::string> names(const std::vector<mien::AxisTick>& ticks) {
  std::vector<std::string> texts;
  for (const auto& tick : ticks)
    if (!tick.text.empty()) texts.push_back(tick.text);
  return texts;
}

TEST(AxisScale, NumbersHaveTheDecimalsTheirStepNeeds) {
  EXPECT_EQ(tickText(0.25, 0.05), "0.25");
  EXPECT_EQ(tickText(-40.0, 20.0), "−40");
  EXPECT_EQ(tickText(-1e-17, 0.1), "0.0");
  EXPECT_EQ(tickText(1e-6, 1e-6), "10⁻⁶");
  EXPECT_EQ(tickText(2e12, 1e12), "2·10¹²");
}

TEST(AxisScale, LinearTicksEndAtNiceNumbersAroundTheData) {
  const ChartAxis axis;
  const AxisScale scale = AxisScale::around(axis, {0.3, 4.7}, false);
  EXPECT_DOUBLE_EQ(scale.begin(), 0.0);
  EXPECT_DOUBLE_EQ(scale.end(), 5.0);
  EXPECT_EQ(names(scale.ticks(axis, 5)), (std::vector<std::string>{"0", "1", "2", "3", "4", "5"}));
  EXPECT_DOUBLE_EQ(scale.fraction(2.5), 0.5);
}

TEST(AxisScale, SpansOfManyDecadesAreLogarithmic) {
  ChartAxis axis;
  axis.scale = ChartAxis::Scale::Automatic;
  EXPECT_FALSE(AxisScale::around(axis, {1.0, 20.0}, false).logarithmic());
  EXPECT_FALSE(AxisScale::around(axis, {-1.0, 1.0, 2000.0}, false).logarithmic());
  const AxisScale scale = AxisScale::around(axis, {0.0, 2.0, 3e7}, false);
  EXPECT_TRUE(scale.logarithmic());
  EXPECT_NEAR(scale.begin(), 1.0, 1e-12);
  EXPECT_NEAR(scale.end(), 1e8, 1e-4);
  EXPECT_NEAR(scale.fraction(1e4), 0.5, 1e-12);
  EXPECT_EQ(scale.fraction(0.0), 0.0);
}

TEST(AxisScale, DecadesAreLeftOutWhenThereAreManyOfThem) {
  const ChartAxis axis;
  const std::vector<mien::AxisTick> ticks = AxisScale(1e-12, 1e12, true).ticks(axis, 5);
  EXPECT_LE(names(ticks).size(), 5u);
  EXPECT_EQ(names(ticks).front(), "10⁻¹²");
  EXPECT_EQ(ticks.size(), 25u);
}

TEST(AxisScale, DecadesOfOneAxisAreWrittenAlike) {
  const ChartAxis axis;
  EXPECT_EQ(names(AxisScale(1e-7, 0.1, true).ticks(axis, 5)),
            (std::vector<std::string>{"10⁻⁷", "10⁻⁵", "10⁻³", "10⁻¹"}));
  EXPECT_EQ(names(AxisScale(10.0, 1e7, true).ticks(axis, 5)), (std::vector<std::string>{"10¹", "10³", "10⁵", "10⁷"}));
  EXPECT_EQ(names(AxisScale(0.1, 1e3, true).ticks(axis, 6)),
            (std::vector<std::string>{"0.1", "1", "10", "100", "1000"}));
}

TEST(AxisScale, ValuesThatAreNotFiniteHaveNoSay) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const AxisScale scale = AxisScale::around(ChartAxis(), {nan, 1.0, infinity, 3.0}, false);
  EXPECT_DOUBLE_EQ(scale.begin(), 0.0);
  EXPECT_DOUBLE_EQ(scale.end(), 3.0);
}

TEST(AxisScale, WithoutValuesOrWithOneThereIsStillAnAxis) {
  EXPECT_LT(AxisScale::around(ChartAxis(), {}, false).begin(), AxisScale::around(ChartAxis(), {}, false).end());
  const AxisScale one = AxisScale::around(ChartAxis(), {7.0}, false);
  EXPECT_LT(one.begin(), 7.0);
  EXPECT_GT(one.end(), 7.0);
}

TEST(AxisScale, BarsStandOnZero) {
  EXPECT_EQ(AxisScale::around(ChartAxis(), {90.0, 100.0}, true).begin(), 0.0);
  EXPECT_GT(AxisScale::around(ChartAxis(), {90.0, 100.0}, false).begin(), 0.0);
}

}  // namespace
