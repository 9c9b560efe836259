#include <gtest/gtest.h>

#include "DeviationText.h"

using namespace mien;

TEST(DeviationText, KeepsTheDigitsThatTheDeviationLeaves) {
  EXPECT_EQ(conciseText(0.12345, 0.0042), "0.123(4)");
  EXPECT_EQ(conciseText(0.0006687, 0.000276), "0.0007(3)");
  EXPECT_EQ(conciseText(1.00137, 0.00134), "1.0014(13)") << "two digits where the first is 1";
  EXPECT_EQ(conciseText(-0.5, 0.199), "-0.5(2)");
  EXPECT_EQ(conciseText(3.21, 1.42), "3.2(1.4)");
  EXPECT_EQ(conciseText(41.7, 23.0), "42(23)");
  EXPECT_EQ(rangeText(-0.0123, 0.00031, "+-"), "-0.0123+-0.0003");
}

TEST(DeviationText, NothingReadsMinusZeroOrLosesASmallNumber) {
  EXPECT_EQ(conciseText(-0.0002, 0.05), "0.00(5)");
  EXPECT_EQ(fixedText(-0.0000001), "0.000");
  EXPECT_EQ(fixedText(-0.00012), "-0.00012");
  EXPECT_EQ(fixedText(1.609), "1.609");
  EXPECT_EQ(fixedText(-0.003), "-0.003") << "no digit that was not given";
  EXPECT_EQ(fixedText(0.0031), "0.0031");
  EXPECT_EQ(rangeText(1.0, 0.0, "+-"), "1.000+-0.000");
}
