#include <gtest/gtest.h>

#include <cmath>

#include "NumberRange.h"

using mien::parseNumberRange;

namespace {

std::vector<double> read(const std::string& text) {
  std::vector<double> numbers;
  EXPECT_EQ(parseNumberRange(text, numbers), "") << text;
  return numbers;
}

}  // namespace

TEST(NumberRange, ReadsListsAndRanges) {
  EXPECT_EQ(read("1,2,5"), (std::vector<double>{1, 2, 5}));
  EXPECT_EQ(read("0.25"), (std::vector<double>{0.25}));
  EXPECT_EQ(read(" 3 , 1:2:3"), (std::vector<double>{3, 1, 1.5, 2}));
  EXPECT_EQ(read("2:1:3"), (std::vector<double>{2, 1.5, 1}));
}

TEST(NumberRange, StepsAreEvenAndTheEndsAsWritten) {
  const auto even = read("0.1:1:10");
  ASSERT_EQ(even.size(), 10u);
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(even[i], 0.1 * (i + 1), 1e-15);
  const auto log = read("0.1:100:50log");
  ASSERT_EQ(log.size(), 50u);
  EXPECT_EQ(log.front(), 0.1);
  EXPECT_EQ(log.back(), 100.0);
  for (int i = 1; i < 50; ++i) EXPECT_NEAR(log[i] / log[i - 1], std::pow(1000.0, 1.0 / 49.0), 1e-12);
}

TEST(NumberRange, FaultsNameThePartAndKeepTheNumbers) {
  const std::vector<std::pair<std::string, std::string>> faults = {{"", "neither"},
                                                                   {"1,,2", "neither"},
                                                                   {"1,two", "'two'"},
                                                                   {"1:2", "'1:2'"},
                                                                   {"1:2:3:4", "neither"},
                                                                   {"1:2:x", "not a range"},
                                                                   {"1:2:1", "2 .. 10000"},
                                                                   {"1:2:-5", "2 .. 10000"},
                                                                   {"1:2:99999999999999999999", "2 .. 10000"},
                                                                   {"0:1:5log", "above 0"},
                                                                   {"-1:1:5log", "above 0"},
                                                                   {"1:inf:5", "not a range"},
                                                                   {"1:2:3.5", "not a range"},
                                                                   {"1:2:10000,1:2:10000", "more than 10000"}};
  for (const auto& [text, word] : faults) {
    std::vector<double> numbers = {7.0};
    const std::string fault = parseNumberRange(text, numbers);
    EXPECT_NE(fault.find(word), std::string::npos) << text << ": " << fault;
    EXPECT_EQ(numbers, (std::vector<double>{7.0}));
  }
}
