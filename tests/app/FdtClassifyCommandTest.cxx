#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ExpressionNames.h"
#include "NamedTables.h"
#include "Program.h"
#include "ReferenceData.h"
#include "SampleRecording.h"
#include "TableFiles.h"

using nlohmann::json;

TEST(FdtClassifyCommand, NamesRecordingsAndTables) {
  const TemporaryFolder folder;
  for (const char* const expression : expressionNames) {
    const std::string file = folder.file("r.csv");
    writeTextFile(file, SampleRecording(*mien::namedTable(expression)).recording());
    for (const std::string& input : {file, std::string(expression)}) {
      const Outcome outcome = runMien({"fdt", "classify", input, "--json"});
      ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
      const json about = json::parse(outcome.output);
      EXPECT_EQ(about["expression"], expression);
      EXPECT_EQ(about["scores"].size(), 6u);
      EXPECT_LT(about["scores"][expression], 1e-9);
      EXPECT_NEAR(about["intensity"], 1.0, 1e-9);
      EXPECT_EQ(about["decisive_regions"].size(), 3u);
    }
  }
}

TEST(FdtClassifyCommand, ComparesWithTablesOfOnesOwn) {
  const TemporaryFolder folder;
  ASSERT_EQ(runMien({"fdt", "blend", "joy:0.7", "-o", folder.file("weak.csv")}).exitCode, 0);
  const Outcome outcome =
      runMien({"fdt", "classify", folder.file("weak.csv"), "--against", "joy", "smile", "-o", folder.file("s.csv")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("nearest: joy"), std::string::npos) << outcome.output;
  EXPECT_EQ(readTextFile(folder.file("s.csv")).rfind("expression,distance,intensity\njoy,", 0), 0u);
  const Outcome one = runMien({"fdt", "classify", "joy", "--against", "smile", "--json"});
  EXPECT_EQ(json::parse(one.output)["expression"], "smile");
  EXPECT_EQ(runMien({"fdt", "classify", "nope"}).exitCode, 1);
  EXPECT_EQ(runMien({"fdt", "classify"}).exitCode, 2);
}

TEST(FdtClassifyCommand, NamesEveryRecordingAtHand) {
  MIEN_REQUIRE_REFERENCE("markers");
  int right = 0;
  for (const char* const expression : expressionNames)
    for (int subject = 1; subject <= 12; ++subject) {
      const std::string name =
          "subject" + std::string(subject < 10 ? "0" : "") + std::to_string(subject) + "_" + expression;
      const Outcome outcome = runMien({"fdt", "classify", referencePath("markers/" + name + ".csv"), "--json"});
      ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
      right += json::parse(outcome.output)["expression"] == expression;
    }
  EXPECT_EQ(right, 72);
}
