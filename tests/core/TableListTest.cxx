#include <gtest/gtest.h>

#include "TableList.h"

using namespace mien;

TEST(TableList, NamesAndWeights) {
  std::vector<WeightedName> tables;
  ASSERT_EQ(parseTableList("joy:0.5,c:/t/anna.csv,fear:-2", tables), "");
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_EQ(tables[0].name, "joy");
  EXPECT_EQ(tables[0].weight, 0.5);
  EXPECT_EQ(tables[1].name, "c:/t/anna.csv");
  EXPECT_EQ(tables[1].weight, 1.0);
  EXPECT_EQ(tables[2].weight, -2.0);
}

TEST(TableList, RefusesWhatIsNoWeight) {
  std::vector<WeightedName> tables;
  EXPECT_NE(parseTableList("joy:much", tables).find("no finite number"), std::string::npos);
  EXPECT_NE(parseTableList("joy:nan", tables).find("no finite number"), std::string::npos);
  EXPECT_NE(parseTableList("joy,fear:2.01", tables).find("outside -2 .. 2"), std::string::npos);
  EXPECT_NE(parseTableList("joy,,fear", tables).find("no name"), std::string::npos);
  EXPECT_TRUE(tables.empty());
}
