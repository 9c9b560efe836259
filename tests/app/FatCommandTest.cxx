#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "DataFile.h"
#include "Program.h"
#include "TemporaryFolder.h"
#include "TextFile.h"

namespace {

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = readDataFile("animation/animation_table.json");
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Outcome checkText(const std::string& text) {
  TemporaryFolder folder;
  writeTextFile(folder.file("table.json"), text);
  return runMien({"fat", "check", folder.file("table.json")});
}

}  // namespace

TEST(FatCommand, TellsWhatTheDefaultTableHolds) {
  const Outcome outcome =
      runMien({"fat", "check", std::string(MIEN_DATA_DIR) + "/animation/animation_table.json", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const auto table = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(table["version"], 3);
  EXPECT_EQ(table["faps"].size(), 46u);
  EXPECT_TRUE(table["faps_missing"].empty());
  EXPECT_TRUE(table["left_out"].empty());
  EXPECT_EQ(table["contacts"].size(), 2u);
}

TEST(FatCommand, NamesLineOrEntryOfAFault) {
  const Outcome broken = checkText(replaced("\"contacts\": [", "\"contacts\": [,"));
  EXPECT_EQ(broken.exitCode, 1);
  EXPECT_NE(broken.errors.find("table.json:4: animation table: it is no valid JSON"), std::string::npos)
      << broken.errors;
  const Outcome curve = checkText(replaced("[\"C28\"]", "[\"C99\"]"));
  EXPECT_EQ(curve.exitCode, 1);
  EXPECT_NE(curve.errors.find("FAP 14: curve \"C99\" is unknown"), std::string::npos) << curve.errors;
  const Outcome point = checkText(replaced("[\"4.2\", 0]", "[\"6.1\", 0]"));
  EXPECT_EQ(point.exitCode, 1);
  EXPECT_NE(point.errors.find("FAP 31: the face has no feature point 6.1"), std::string::npos) << point.errors;
  EXPECT_EQ(runMien({"fat", "check", "/nowhere.json"}).exitCode, 1);
  EXPECT_EQ(runMien({"fat", "check"}).exitCode, 2);
}

TEST(FatCommand, RefusesTheMalformedTables) {
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(std::string(MIEN_TEST_DIR) + "/data/malformed/fat")) {
    ++files;
    const Outcome outcome = runMien({"fat", "check", file.path().string()});
    EXPECT_EQ(outcome.exitCode, 1) << file.path();
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_NE(outcome.errors.find(file.path().filename().string()), std::string::npos) << outcome.errors;
  }
  EXPECT_GE(files, 8);
}

TEST(FatCommand, ATableOfOnesOwnMovesTheFace) {
  TemporaryFolder folder;
  writeTextFile(folder.file("table.json"),
                replaced("\"borders\": [-1000, 0, 1000], \"parts\": [\n      {\"curves\": [\"C28\"], \"above\"",
                         "\"borders\": [-1000, 0, 1000], \"parts\": [\n      {\"curves\": [\"C28\"], \"slopes\": "
                         "[[0,0,2],[0,0,2]], \"above\""));
  const Outcome own =
      runMien({"curves", "--fat", folder.file("table.json"), "--set", "14=100", "-o", folder.file("a.vtp")});
  EXPECT_EQ(own.exitCode, 0) << own.errors;
}
