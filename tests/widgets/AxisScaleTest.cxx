#include <gtest/gtest.h>

#include <limits>
#include <set>

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
  EXPECT_EQ(tickText(0.0, 1e-13), "0");
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

/// Whatever an axis shows and however little room it has; numbers lie on the axis and differ.
TEST(AxisScale, EveryAxisHasTwoNumbersOrMore) {
  for (const bool logarithmic : {false, true})
    for (double begin = 1e-9; begin < 1e9; begin *= 1.7)
      for (const double ratio : {1.001, 1.05, 1.3, 1.9, 2.6, 4.9, 7.0, 9.99, 10.0, 13.0, 30.0, 99.0, 190.0, 2e4, 3e11})
        for (int most = 1; most <= 8; ++most) {
          const AxisScale scale(begin, begin * ratio, logarithmic);
          const std::vector<mien::AxisTick> ticks = scale.ticks({}, most);
          const std::vector<std::string> texts = names(ticks);
          ASSERT_GE(texts.size(), 2u) << begin << " to " << begin * ratio << ", " << most;
          ASSERT_LE(texts.size(), most + 5u) << begin << " to " << begin * ratio << ", " << most;
          ASSERT_EQ(std::set<std::string>(texts.begin(), texts.end()).size(), texts.size()) << begin << " " << ratio;
          for (const auto& tick : ticks) {
            ASSERT_GE(scale.fraction(tick.value), -1e-8) << tick.value;
            ASSERT_LE(scale.fraction(tick.value), 1.0 + 1e-8) << tick.value;
          }
        }
}

TEST(AxisScale, FewDecadesHaveNumbersBetweenThem) {
  const ChartAxis axis;
  EXPECT_EQ(names(AxisScale(0.5, 9.0, true).ticks(axis, 2)), (std::vector<std::string>{"0.5", "1", "2", "5"}));
  EXPECT_EQ(names(AxisScale(3e-7, 4e-6, true).ticks(axis, 4)), (std::vector<std::string>{"5·10⁻⁷", "10⁻⁶", "2·10⁻⁶"}));
  EXPECT_EQ(names(AxisScale(0.52, 100.0, true).ticks(axis, 2)), (std::vector<std::string>{"1", "100"}));
  EXPECT_EQ(names(AxisScale(2.1, 4.2, true).ticks(axis, 4)), (std::vector<std::string>{"3", "4"}));
}

/// A step of its own that is too coarse for the axis gives way.
TEST(AxisScale, AStepThatLeavesOneNumberIsNotUsed) {
  ChartAxis axis;
  axis.step = 90.0;
  EXPECT_EQ(names(AxisScale(0.0, 50.0, false).ticks(axis, 5)),
            (std::vector<std::string>{"0", "10", "20", "30", "40", "50"}));
  EXPECT_EQ(names(AxisScale(0.0, 180.0, false).ticks(axis, 5)), (std::vector<std::string>{"0", "90", "180"}));
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

TEST(AxisScale, LargeNumbersCloseTogetherAreWritten) {
  EXPECT_EQ(mien::tickText(1234567.0, 1.0), "1.234567·10⁶");
  EXPECT_EQ(mien::tickText(250000.5, 1e-9).substr(0, 4), "2.50");
  EXPECT_EQ(mien::tickText(3.0, 1e-7), "3.000000·10⁰");
  EXPECT_EQ(mien::tickText(std::numeric_limits<double>::infinity(), 1.0), "");
  EXPECT_EQ(mien::tickText(std::numeric_limits<double>::quiet_NaN(), 1.0), "");
}

}  // namespace
