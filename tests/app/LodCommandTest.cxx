#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "Program.h"
#include "ReferenceData.h"

namespace {

using nlohmann::json;

std::vector<std::string> lodOf(const std::string& head, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"lod",          referencePath("heads/" + head),
                                        "--landmarks",  referencePath("heads/landmarks68.csv"),
                                        "--points",     "10",
                                        "--spacing",    "6mm",
                                        "--tolerances", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST(LodCommand, TellsBytesAndDistancesInEveryForm) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  const TemporaryFolder folder;
  const Outcome outcome = runMien(lodOf(
      "subject01_neutral.ply", {"--json", "-o", folder.file("a.csv"), "-o", folder.file("a.svg"), "--width", "85"}));
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const json levels = json::parse(outcome.output)["levels"];
  EXPECT_EQ(levels[0]["representation"], "scan file");
  EXPECT_EQ(levels[0]["bytes"], 416165);
  EXPECT_LT(levels[1]["bytes"], 416165);
  EXPECT_TRUE(levels[2]["rms_mm"].is_null());
  const auto face =
      std::find_if(levels.begin(), levels.end(), [](const json& row) { return row["representation"] == "PDE face"; });
  ASSERT_NE(face, levels.end());
  EXPECT_EQ((*face)["bytes"], 29 * 10 * 12);
  EXPECT_GT((*face)["hausdorff_mm"], (*face)["rms_mm"]);
  const std::string table = readTextFile(folder.file("a.csv")), figure = readTextFile(folder.file("a.svg"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + static_cast<long>(levels.size()));
  for (const char* const part : {"compact face", "decimated mesh", "packed mesh", "modes", "Hausdorff", "bytes"})
    EXPECT_NE(figure.find(part), std::string::npos) << part;
}

TEST(LodCommand, TakesCurvesMeasuredBefore) {
  MIEN_REQUIRE_REFERENCE("heads/subject01_neutral.ply");
  const TemporaryFolder folder;
  const std::string scan = referencePath("heads/subject01_neutral.ply"), curves = folder.file("c.vtp");
  ASSERT_EQ(
      runMien({"acquire", scan, "--landmarks", referencePath("heads/landmarks68.csv"), "--points", "10", "-o", curves})
          .exitCode,
      0);
  const Outcome outcome = runMien({"lod", scan, "--face", curves, "--tolerances", "1", "--spacing", "8"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("PDE face"), std::string::npos);
}

TEST(LodCommand, WrongValuesAndFilesAreSaid) {
  const TemporaryFolder folder;
  EXPECT_EQ(runMien({"lod", folder.file("none.ply"), "--landmarks", "l.csv"}).exitCode, 1);
  EXPECT_EQ(runMien({"lod", folder.file("none.ply"), "--landmarks", "l.csv", "--tolerances", "0"}).exitCode, 2);
  EXPECT_EQ(runMien({"lod", folder.file("none.ply"), "--landmarks", "l.csv", "-o", "a.txt"}).exitCode, 2);
  EXPECT_EQ(runMien({"lod", folder.file("none.ply"), "--spacing", "0"}).exitCode, 2);
  EXPECT_EQ(runMien({"lod", folder.file("none.ply"), "--face", "f.vtp", "--units", "cm"}).exitCode, 2);
  EXPECT_EQ(runMien({"lod"}).exitCode, 2);
}
