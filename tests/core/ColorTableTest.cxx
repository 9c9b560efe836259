#include <gtest/gtest.h>

#include "ColorTable.h"

TEST(ColorTable, GetsLighterSteadily) {
  ASSERT_EQ(mien::ColorTable::all().size(), 6u);
  for (const mien::ColorTable& table : mien::ColorTable::all()) {
    double before = -1.0;
    for (double t = 0.0; t <= 1.0; t += 1.0 / 51.0) {
      const auto color = table.at(t);
      const double light = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
      const bool darkens = table.diverging && t > 0.5;
      EXPECT_GT(darkens ? before : light, (darkens ? light : before) - 0.004) << table.name << " at " << t;
      before = light;
    }
    EXPECT_EQ(table.at(-1.0), table.at(0.0));
    EXPECT_EQ(table.at(2.0), table.at(1.0));
    EXPECT_EQ(mien::ColorTable::find(table.name), &table);
  }
  EXPECT_EQ(mien::ColorTable::find("jet"), nullptr);
}
