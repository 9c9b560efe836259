#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

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

/// Every number of a table below its header.
std::vector<double> numbersIn(const std::string& file) {
  std::istringstream lines(readTextFile(file));
  std::vector<double> numbers;
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);) {
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');)
      if (!cell.empty() && cell.find_first_not_of("-+.e0123456789") == std::string::npos)
        numbers.push_back(std::stod(cell));
  }
  return numbers;
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
  ASSERT_EQ(runMien({"curves", "--set", "14=100", "-o", folder.file("default.csv")}).exitCode, 0);
  ASSERT_EQ(
      runMien({"curves", "--fat", folder.file("table.json"), "--set", "14=100", "-o", folder.file("own.csv")}).exitCode,
      0);
  ASSERT_EQ(runMien({"curves", "-o", folder.file("neutral.csv")}).exitCode, 0);
  // The same way, twice as far: FAP 14 thrusts the jaw forward, 1 per FAP value by default.
  const std::vector<double> neutral = numbersIn(folder.file("neutral.csv")),
                            once = numbersIn(folder.file("default.csv")), twice = numbersIn(folder.file("own.csv"));
  ASSERT_EQ(once.size(), neutral.size());
  ASSERT_EQ(twice.size(), neutral.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < neutral.size(); ++i) {
    EXPECT_NEAR(twice[i] - neutral[i], 2.0 * (once[i] - neutral[i]), 1e-5) << i;
    largest = std::max(largest, std::abs(once[i] - neutral[i]));
  }
  EXPECT_GT(largest, 1.0);
}

/// Without contacts nothing makes room: what is left of the movement is told.
TEST(FatCommand, AFaceDrawnBackFromCrossingsIsTold) {
  TemporaryFolder folder;
  writeTextFile(folder.file("table.json"),
                R"({"format": "mien animation table", "version": 3, "contacts": [], "faps": [{"fap": 63,
                    "borders": [-1000, 0, 1000], "parts": [{"curves": ["C15"], "slopes": [[0, 1, 0], [0, 1, 0]],
                    "profile": {"shape": "linear", "knots": [["9.3-30", 0], ["9.3", 1], ["9.3+30", 0]]}}]}]})");
  const std::string output = folder.file("a.csv");
  const Outcome far = runMien({"curves", "--fat", folder.file("table.json"), "--set", "63=300", "-o", output});
  EXPECT_EQ(far.exitCode, 0) << far.errors;
  EXPECT_NE(far.errors.find("the whole face keeps only 37 % of its movement"), std::string::npos) << far.errors;
  const Outcome near = runMien({"curves", "--fat", folder.file("table.json"), "--set", "63=100", "-o", output});
  EXPECT_EQ(near.errors, "");
}

TEST(FatCommand, ATableThatMovesNothingIsRefused) {
  const Outcome empty = checkText("{\"format\": \"mien animation table\", \"version\": 2, \"faps\": []}");
  EXPECT_EQ(empty.exitCode, 1);
  EXPECT_NE(empty.errors.find("\"faps\" is empty"), std::string::npos) << empty.errors;
}

TEST(FatCommand, ATableBeyondAllMeasureIsRefused) {
  std::string borders = "-1000, 0, 1";
  for (int i = 2; i < 80; ++i) borders += ", " + std::to_string(i);
  const Outcome many = checkText(replaced("\"borders\": [-1000, 0, 1000]", "\"borders\": [" + borders + "]"));
  EXPECT_EQ(many.exitCode, 1);
  EXPECT_NE(many.errors.find("there are 81 borders; at most 64 are read"), std::string::npos) << many.errors;
  const std::string part = "{\"curves\": [\"C28\"], \"profile\": {\"shape\": \"linear\", \"knots\": []}}";
  std::string parts = part;
  for (int i = 1; i < 65; ++i) parts += "," + part;
  const Outcome crowded = checkText(
      "{\"format\": \"mien animation table\", \"version\": 2, \"faps\": [{\"fap\": 3, \"borders\": [0, 1], \"parts\": "
      "[" +
      parts + "]}]}");
  EXPECT_EQ(crowded.exitCode, 1);
  EXPECT_NE(crowded.errors.find("FAP 3: it has 65 parts; at most 64 are read"), std::string::npos) << crowded.errors;
}
