#include <gtest/gtest.h>

#include "TemporaryFolder.h"
#include "TextFile.h"
#include "TextFileReader.h"

TEST(TextFileReader, MemoryFollowsTheFileNotTheLimit) {
  const TemporaryFolder folder;
  const std::string file = folder.file("small.csv"), content(200000, 'x');
  writeTextFile(file, content);
  std::string text = "before";
  EXPECT_EQ(mien::readTextFile(file, 256'000'000, text), "");
  EXPECT_EQ(text, content);
  EXPECT_LT(text.capacity(), 1'000'000u);
}

TEST(TextFileReader, RefusesWhatIsTooLargeOrNoFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.csv");
  writeTextFile(file, std::string(1000, 'x'));
  std::string text;
  EXPECT_EQ(mien::readTextFile(file, 1000, text, "table"), "");
  EXPECT_EQ(mien::readTextFile(file, 999, text, "table"), " it is too large for a table: more than 999 bytes");
  EXPECT_EQ(mien::readTextFile(folder.file("none"), 999, text, "table").rfind(" it cannot be opened; give a table", 0),
            0u);
  EXPECT_NE(mien::readTextFile(folder.file("."), 999, text).find("folder"), std::string::npos);
}
