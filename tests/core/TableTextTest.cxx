#include <gtest/gtest.h>

#include <cmath>

#include "TableStatistics.h"
#include "TableText.h"

using namespace mien;

namespace {

DeformationTable sample(double phase) {
  DeformationTable table;
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 12; ++k) table.maps[i].coefficients(k / 6, k % 6) = std::sin(phase + 13.0 * i + k) / 3.0;
  table.largestDisplacement = 0.1;
  return table;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

void expectTableFault(const std::string& text, const std::string& start, const std::string& part) {
  DeformationTable table;
  table.largestDisplacement = 7.0;
  const std::string fault = parseTable(text, table);
  EXPECT_EQ(fault.rfind(start, 0), 0u) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault;
  EXPECT_EQ(table.largestDisplacement, 7.0);
}

}  // namespace

TEST(TableText, WhatIsWrittenIsReadBackExactly) {
  const DeformationTable mean = meanTable({sample(0.0), sample(0.3)});
  for (const DeformationTable& table : {mean, sample(1.0)}) {
    DeformationTable read;
    ASSERT_EQ(parseTable(writeTable(table, "two\nlines"), read), "");
    EXPECT_EQ(read.largestDisplacement, table.largestDisplacement);
    ASSERT_EQ(read.deviations.has_value(), table.deviations.has_value());
    for (int i = 0; i < 16; ++i) {
      EXPECT_EQ(read.maps[i].coefficients, table.maps[i].coefficients);
      if (table.deviations) {
        EXPECT_EQ(read.deviations->at(i), table.deviations->at(i));
      }
    }
  }
}

TEST(TableText, NumbersOfRecordingsAreKeptAndFilesWithoutThemKnowEveryRegion) {
  DeformationTable table = sample(0.2), read;
  EXPECT_EQ(writeTable(table).find(",n"), std::string::npos);
  ASSERT_EQ(parseTable(writeTable(table), read), "");
  EXPECT_TRUE(read.unknownRegions().empty());
  table.counts.emplace().fill(12);
  table.counts->at(3) = 0;
  ASSERT_EQ(parseTable(writeTable(table), read), "");
  EXPECT_EQ(read.counts, table.counts);
  EXPECT_EQ(read.unknownRegions(), std::vector<int>{4});
  for (const char* wrong : {"-1", "0.5", "", "9999999"})
    expectTableFault(replaced(writeTable(table), ",0,0.1\n", std::string(",") + wrong + ",0.1\n"), "5: ", "column n");
}

TEST(TableText, ZerosHaveNoSign) {
  DeformationTable table;
  for (QuadraticMap& map : table.maps) map = map.mirrored();
  EXPECT_EQ(writeTable(table).find("-0"), std::string::npos);
}

TEST(TableText, NamesTheLineAtFault) {
  const std::string good = writeTable(DeformationTable());
  const std::string row = "5,0,0,0,1,0,0,0,0,0,0,1,0\n";
  ASSERT_NE(good.find(row), std::string::npos);
  expectTableFault("", "1: ", "empty");
  expectTableFault(replaced(good, ",b6", ",c6"), "1: ", "b6");
  expectTableFault(replaced(good, "region", "area"), "1: ", "region");
  expectTableFault(replaced(good, ",b6", ",b6,a1_sd"), "1: ", "all twelve");
  expectTableFault(replaced(good, row, ""), "16: ", "region 5 is missing");
  expectTableFault(replaced(good, row, row + row), "7: ", "region 5 is given twice");
  expectTableFault(replaced(good, row, "5,0,0,0,1,0,0,0,0,0,0,1\n"), "6: ", "12 cells");
  expectTableFault(replaced(good, row, "5,0,0,0,1,0,0,0,nan,0,0,1,0\n"), "6: ", "region 5");
  expectTableFault(replaced(good, row, "17,0,0,0,1,0,0,0,0,0,0,1,0\n"), "6: ", "1 to 16");
}
