#include <gtest/gtest.h>

#include <limits>

#include "NumberText.h"

using namespace mien;

TEST(NumberText, ReadsWholeFiniteDecimalNumbersOnly) {
  EXPECT_EQ(parseNumber("-1.5e3"), -1500.0);
  EXPECT_EQ(parseNumber("+2"), 2.0);
  EXPECT_EQ(parseNumber(".5"), 0.5);
  for (const char* text : {"", "+", "-", "+-1", "1,5", "1.5x", "0x10", "nan", "inf", "1e999", " 1", "1 "})
    EXPECT_FALSE(parseNumber(text).has_value()) << text;
}

TEST(NumberText, NumbersTooSmallToHoldAreZero) {
  for (const char* text :
       {"1e-400", "-1e-400", "+1E-400", "123456789012345e-400", "0.00001e-320", "1e-99999999999999999999"})
    EXPECT_EQ(parseNumber(text), 0.0) << text;
  const std::string zeros(400, '0');
  EXPECT_EQ(parseNumber("0." + zeros + "1"), 0.0);
  EXPECT_FALSE(parseNumber("1" + zeros).has_value());
  EXPECT_NEAR(parseNumber("0." + zeros + "1e401").value_or(0.0), 1.0, 1e-15);
  for (const char* text : {"1e400", "-1e400", "0.00001e320", "1e-400x"})
    EXPECT_FALSE(parseNumber(text).has_value()) << text;
}

TEST(NumberText, WholeNumbersTooLargeBecomeTheLargest) {
  EXPECT_EQ(parseWholeNumber("408"), 408);
  EXPECT_EQ(parseWholeNumber("99999999999999999999"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(parseWholeNumber("-99999999999999999999"), std::numeric_limits<std::int64_t>::min());
  for (const char* text : {"", "1.0", "x", "99999999999999999999x"})
    EXPECT_FALSE(parseWholeNumber(text).has_value()) << text;
}

TEST(NumberText, AppendsTheShortestExactForm) {
  std::string text;
  appendNumber(text, 0.1);
  EXPECT_EQ(text, "0.1");
  EXPECT_EQ(parseNumber("0.30000000000000004"), 0.1 + 0.2);
}

TEST(NumberText, QuotesAreShortAndHarmless) {
  EXPECT_EQ(inQuotes("abc"), "'abc'");
  EXPECT_EQ(inQuotes("a\nb"), "'a?b'");
  EXPECT_EQ(inQuotes(std::string(100, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(NumberText, MessagesHaveThreeDigitsAndNoNoise) {
  for (const auto& [number, text] : {std::pair{67.1, "67.1"},
                                     {0.141421356, "0.141"},
                                     {-173.205, "-173"},
                                     {0.0, "0"},
                                     {1234567.0, "1230000"},
                                     {2.0, "2"},
                                     {0.00123456, "0.00123"},
                                     {99.96, "100"}})
    EXPECT_EQ(roundedText(number), text);
}
