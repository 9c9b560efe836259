/// mien fdt mean, mirror, blend, check and show.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "CsvRows.h"
#include "ExpressionNames.h"
#include "MarkerTable.h"
#include "NamedTables.h"
#include "PackedTable.h"
#include "Program.h"
#include "ReferenceData.h"
#include "SampleRecording.h"
#include "TableFiles.h"

using nlohmann::json;

namespace {

Outcome runFdt(std::vector<std::string> words) {
  words.insert(words.begin(), "fdt");
  return runMien(words);
}

}  // namespace

TEST(FdtMeanCommand, AveragesTablesAndRecordings) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("r.csv"), SampleRecording(*mien::namedTable("joy")).recording());
  const std::string mean = folder.file("m.csv");
  const Outcome outcome =
      runFdt({"mean", folder.file("r.csv"), "surprise", "smile", "-o", mean, "--comment", "Three", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(readTextFile(mean).rfind("# Three\nregion,", 0), 0u);
  const json about = json::parse(outcome.output);
  EXPECT_EQ(about["tables"], 3);
  EXPECT_LT(about["mean_rms"], 1e-12);
  const mien::DeformationTable table = tableFrom(mean);
  ASSERT_TRUE(table.deviations);
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 12; ++k) {
      const auto of = [&](const char* name) { return mien::namedTable(name)->maps[i].coefficients(k / 6, k % 6); };
      const double a = of("joy"), b = of("surprise"), c = of("smile"), m = (a + b + c) / 3.0;
      EXPECT_NEAR(table.maps[i].coefficients(k / 6, k % 6), m, 1e-9);
      const double sd = std::sqrt(((a - m) * (a - m) + (b - m) * (b - m) + (c - m) * (c - m)) / 2.0);
      EXPECT_NEAR(table.deviations->at(i)(k / 6, k % 6), sd, 1e-9);
    }
}

TEST(FdtMeanCommand, RegionsWithoutMarkersAreLeftOutAndCounted) {
  const TemporaryFolder folder;
  const std::string joy = SampleRecording(*mien::namedTable("joy")).recording();
  const mien::FacialRegions regions = regionMap();
  mien::MarkerTable markers;
  ASSERT_EQ(markers.parse(joy), "");
  std::string partly, line;
  std::istringstream lines(joy);
  for (int number = 1; std::getline(lines, line); ++number) {
    bool forehead = false;
    for (const mien::Marker& marker : markers.markers)
      forehead =
          forehead || (marker.line == number && regions.nearest(markers.neutral.apply(marker.neutral).head<2>()) <= 2);
    if (!forehead) partly += line + "\n";
  }
  writeTextFile(folder.file("whole.csv"), joy);
  writeTextFile(folder.file("partly.csv"), partly);
  const Outcome outcome =
      runFdt({"mean", folder.file("whole.csv"), folder.file("partly.csv"), "-o", folder.file("m.csv"), "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_NE(outcome.errors.find("whose means are those of the others (n): 1 (1), 2 (1)"), std::string::npos);
  const mien::DeformationTable mean = tableFrom(folder.file("m.csv"));
  EXPECT_LT(tableDifference(mean, *mien::namedTable("joy")), 1e-9) << "the forehead moves as in the one that shows it";
  EXPECT_EQ(mean.counts->at(0), 1);
  EXPECT_EQ(mean.counts->at(2), 2);
  const Outcome readable =
      runFdt({"mean", folder.file("partly.csv"), folder.file("partly.csv"), "-o", folder.file("n.csv")});
  EXPECT_EQ(readable.exitCode, 0) << readable.errors;
  EXPECT_EQ(tableFrom(folder.file("n.csv")).unknownRegions(), (std::vector<int>{1, 2}));
  const Outcome shown = runFdt({"show", folder.file("n.csv")});
  EXPECT_NE(shown.output.find("regions 1, 2 are not known"), std::string::npos) << shown.output;
  const Outcome checked = runFdt({"check", folder.file("partly.csv"), "--against", "joy", "--json"});
  EXPECT_EQ(json::parse(checked.output)["coefficients"], 14 * 12);
  ASSERT_EQ(runFdt({"pack", folder.file("n.csv"), "-o", folder.file("n.fdt")}).exitCode, 0);
  const Outcome told = runMien({"info", folder.file("n.fdt"), "--json"});
  EXPECT_EQ(json::parse(told.output)["table"]["regions_not_known"], (std::vector<int>{1, 2})) << told.errors;
}

TEST(FdtTables, WhatIsNoTableIsCalledByItsName) {
  const TemporaryFolder folder;
  const std::string recording = folder.file("r.csv"), out = folder.file("t.csv");
  writeTextFile(recording, SampleRecording(*mien::namedTable("joy")).recording());
  for (const std::vector<std::string>& words : {std::vector<std::string>{"mirror", recording, "-o", out},
                                                {"blend", recording, "-o", out},
                                                {"classify", "joy", "--against", recording},
                                                {"check", "joy", "--against", recording}}) {
    const Outcome outcome = runFdt(words);
    EXPECT_EQ(outcome.exitCode, 1) << words[0];
    EXPECT_NE(outcome.errors.find("this is a recording of markers"), std::string::npos) << outcome.errors;
  }
  EXPECT_NE(runFdt({"show", folder.file(".")}).errors.find("it is a folder"), std::string::npos);
  const Outcome unknown = runFdt({"frob"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.errors.find("there is no command 'fdt frob'; the commands are fit, "), std::string::npos);
  EXPECT_NE(runFdt({"classify", "joy", "--against", "joy", "joy"}).errors.find("joy twice"), std::string::npos);
  EXPECT_EQ(json::parse(runMien({"info", recording, "--json"}).output)["table"]["kind"],
            "recording of markers before and after");
}

TEST(FdtClassifyCommand, SeveralInputsGiveARowEach) {
  const Outcome outcome = runFdt({"classify", "joy", "fear", "surprise", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const json about = json::parse(outcome.output);
  ASSERT_EQ(about.size(), 3u);
  EXPECT_EQ(about[0]["expression"], "joy");
  EXPECT_EQ(about[2]["expression"], "surprise");
  EXPECT_NE(runFdt({"classify", "joy", "fear"}).output.find("second_distance"), std::string::npos);
}

TEST(FdtMeanCommand, ReproducesTheMeanTables) {
  MIEN_REQUIRE_REFERENCE("markers");
  const TemporaryFolder folder;
  for (const char* const expression : expressionNames) {
    std::vector<std::string> words = {"mean", "-o", folder.file("m.csv"), "--json"};
    for (int subject = 1; subject <= 12; ++subject)
      words.push_back(referencePath("markers/subject" + std::string(subject < 10 ? "0" : "") + std::to_string(subject) +
                                    "_" + expression + ".csv"));
    const Outcome outcome = runFdt(words);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_LT(tableDifference(tableFrom(folder.file("m.csv")), *mien::namedTable(expression)), 1e-12) << expression;
    EXPECT_LT(json::parse(outcome.output)["mean_rms"], 0.025);
  }
}

TEST(FdtMirrorCommand, TwiceIsTheTable) {
  const TemporaryFolder folder;
  ASSERT_EQ(runFdt({"mirror", "joy", "-o", folder.file("a.csv")}).exitCode, 0);
  ASSERT_EQ(runFdt({"mirror", folder.file("a.csv"), "-o", folder.file("b.csv")}).exitCode, 0);
  EXPECT_GT(tableDifference(tableFrom(folder.file("a.csv")), *mien::namedTable("joy")), 1e-4);
  EXPECT_EQ(tableDifference(tableFrom(folder.file("b.csv")), *mien::namedTable("joy")), 0.0);
  EXPECT_EQ(tableFrom(folder.file("b.csv")).deviations->at(3), mien::namedTable("joy")->deviations->at(3));
}

TEST(FdtBlendCommand, WeightsThatSumToOneMix) {
  const TemporaryFolder folder;
  ASSERT_EQ(runFdt({"blend", "joy:0.25", "fear:0.75", "-o", folder.file("a.csv")}).exitCode, 0);
  const mien::DeformationTable mixed = mien::namedTable("joy")->blended(*mien::namedTable("fear"), 0.75);
  EXPECT_LT(tableDifference(tableFrom(folder.file("a.csv")), mixed), 1e-15);
  ASSERT_EQ(runFdt({"blend", "joy", "-o", folder.file("b.csv")}).exitCode, 0);
  EXPECT_TRUE(tableFrom(folder.file("b.csv")).deviations);
  EXPECT_EQ(runFdt({"blend", "joy:2.5", "-o", folder.file("c.csv")}).exitCode, 2);
  EXPECT_EQ(runFdt({"blend", "joy"}).exitCode, 2);
}

TEST(FdtCheckCommand, ListsWhatLiesOutside) {
  const TemporaryFolder folder;
  mien::DeformationTable table = *mien::namedTable("joy");
  table.maps[4].coefficients(1, 2) += 3.0 * table.deviations->at(4)(1, 2);
  table.maps[11].coefficients(0, 5) -= 1.5 * table.deviations->at(11)(0, 5);
  table.maps[12].coefficients(0, 5) -= 0.9 * table.deviations->at(12)(0, 5);
  writeTextFile(folder.file("t.csv"), mien::writeTable(table));
  const Outcome outcome =
      runFdt({"check", folder.file("t.csv"), "--against", "joy", "--json", "-o", folder.file("l.csv")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  const json about = json::parse(outcome.output);
  EXPECT_EQ(about["outside"], 2);
  EXPECT_EQ(about["list"][0]["region"], 5);
  EXPECT_EQ(about["list"][0]["coefficient"], "b3");
  EXPECT_NEAR(about["list"][0]["sds"], 3.0, 1e-9);
  EXPECT_NEAR(about["list"][1]["sds"], -1.5, 1e-9);
  EXPECT_EQ(csvRows(folder.file("l.csv")).size(), 2u);
  const Outcome same = runFdt({"check", "joy", "--against", "joy"});
  EXPECT_EQ(same.exitCode, 0);
  EXPECT_NE(same.output.find("0 of 192"), std::string::npos) << same.output;
  const Outcome plain = runFdt({"check", "joy", "--against", "smile"});
  EXPECT_EQ(plain.exitCode, 1);
  EXPECT_NE(plain.errors.find("no standard deviations"), std::string::npos);
}

TEST(FdtShowCommand, PrintsAndDrawsATable) {
  const TemporaryFolder folder;
  for (const char* const width : {"85", "170"}) {
    const Outcome outcome =
        runFdt({"show", "joy", "--width", width, "-o", folder.file("j.svg"), "-o", folder.file("j.csv")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const std::string figure = readTextFile(folder.file("j.svg"));
    EXPECT_EQ(figure.find("<image"), std::string::npos);
    for (const char* const part : {">16<", "Regions", "±", "true to scale", "1 pupil unit,", "mien fdt show joy"})
      EXPECT_NE(figure.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(csvRows(folder.file("j.csv")).size(), 192u);
  const json about = json::parse(runFdt({"show", "smile", "--json"}).output);
  EXPECT_EQ(about["regions"].size(), 16u);
  EXPECT_EQ(about["regions"][13]["a"][3], 1.609);
  EXPECT_FALSE(about["regions"][13].contains("a_sd"));
  EXPECT_EQ(json::parse(runFdt({"show", "joy", "--json"}).output)["regions"][0]["b_sd"].size(), 6u);
  EXPECT_EQ(runFdt({"show", "joy", "--arrows", "0"}).exitCode, 2);
}

TEST(FdtShowCommand, NoNumberReadsZeroThatIsNot) {
  for (const char* const table : {"joy", "smile"}) {
    const std::string text = runFdt({"show", table}).output;
    EXPECT_EQ(text.find("-0.000 "), std::string::npos) << table;
    EXPECT_EQ(text.find("+-0.000 "), std::string::npos) << table;
  }
}

TEST(FdtTables, OptionsWithoutEffectAreRefused) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"show", "joy", "--y-down"},
                                                {"classify", "joy", "--mirrored"},
                                                {"check", "joy", "--against", "joy", "--pupils", "a,b"},
                                                {"mean", "joy", "fear", "--y-down", "-o", folder.file("m.csv")},
                                                {"mirror", "joy", "--y-down", "-o", folder.file("m.csv")}}) {
    const Outcome outcome = runFdt(words);
    EXPECT_EQ(outcome.exitCode, 2) << words[0] << outcome.errors;
  }
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

/// No table is written that no reader would take.
TEST(FdtTables, CoefficientsBeyondTheLimitAreNeitherReadNorWritten) {
  const TemporaryFolder folder;
  mien::DeformationTable table;
  table.maps[8].coefficients(0, 2) = 60.0;
  writeTextFile(folder.file("steep.csv"), mien::writeTable(table));
  const std::string steep = folder.file("steep.csv") + ":1";
  const Outcome sum = runFdt({"blend", steep, steep, "-o", folder.file("sum.csv")});
  EXPECT_EQ(sum.exitCode, 1);
  EXPECT_NE(sum.errors.find("sum.csv is not written: region 9 has a coefficient beyond -100 .. 100"), std::string::npos)
      << sum.errors;
  EXPECT_EQ(runFdt({"blend", steep, "joy:0.5", "-o", folder.file("within.csv")}).exitCode, 0);
  table.maps[8].coefficients(0, 2) = 102.0;
  writeTextFile(folder.file("steeper.csv"), mien::writeTable(table));
  writeTextFile(folder.file("steeper.fdt"), mien::packTable(table, 16));
  for (const char* const file : {"steeper.csv", "steeper.fdt"}) {
    const Outcome shown = runFdt({"show", folder.file(file)});
    EXPECT_EQ(shown.exitCode, 1);
    EXPECT_NE(shown.errors.find("beyond -100 .. 100"), std::string::npos) << shown.errors;
  }
  const std::string beside =
      "marker,neutral_x,neutral_y,expression_x,expression_y\npupil_left,30,0,30,0\n"
      "pupil_right,-30,0,-30,0\n";
  std::string markers = beside;
  for (int i = 0; i < 12; ++i) {
    const double x = -3.0 + 2.0 * (i % 4), y = -105.0 + 2.0 * (i / 4);
    markers += "m" + std::to_string(i) + "," + std::to_string(x) + "," + std::to_string(y) + "," +
               std::to_string(x + 9.0 * x * x) + "," + std::to_string(y) + "\n";
  }
  writeTextFile(folder.file("r.csv"), markers);
  const Outcome fitted = runFdt({"fit", folder.file("r.csv"), "-o", folder.file("fit.csv")});
  EXPECT_EQ(fitted.exitCode, 1);
  EXPECT_NE(fitted.errors.find("region 16 has a coefficient beyond"), std::string::npos) << fitted.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 5);
}

TEST(FdtTables, WhatTheyAreMadeFromIsNotReplaced) {
  const TemporaryFolder folder;
  const std::string table = folder.file("t.csv"), packed = folder.file("t.fdt"), markers = folder.file("m.csv"),
                    other = folder.file("") + "/./t.csv";
  const std::string text = mien::writeTable(*mien::namedTable("joy"));
  writeTextFile(table, text);
  const std::string bytes = mien::packTable(*mien::namedTable("joy"), 16);
  writeTextFile(packed, bytes);
  const std::string recording = SampleRecording(*mien::namedTable("joy")).recording();
  writeTextFile(markers, recording);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"blend", table + ":0.5", "joy:0.5", "-o", table},
        {"blend", "joy", table + ":-1", "-o", other},
        {"mirror", table, "-o", other},
        {"mean", "joy", table, "-o", table},
        {"apply", table + ":0.5", "smile", markers, "-o", markers},
        {"apply", "smile", table + ":0.5", markers, "-o", table},
        {"fit", markers, "-o", markers},
        {"from-fap", "joy", "--fdt", table + ":0.5,fear:0.2", "-o", table},
        {"from-fap", "joy", "--fdt", "fear:0.2," + table + ":0.5", "-o", other},
        {"show", table, "-o", other},
        {"classify", markers, "--against", "joy", table, "-o", table},
        {"check", markers, "--against", table, "-o", table},
        {"pack", packed, "-o", packed}}) {
    const Outcome outcome = runFdt(words);
    EXPECT_EQ(outcome.exitCode, 2) << words[0] << outcome.errors;
    EXPECT_NE(outcome.errors.find("which it would replace"), std::string::npos) << words[0] << outcome.errors;
  }
  EXPECT_EQ(readTextFile(table), text);
  EXPECT_EQ(readTextFile(packed), bytes);
  EXPECT_EQ(readTextFile(markers), recording);
  EXPECT_EQ(entriesIn(folder.file("")), 3);
}

TEST(FdtClassifyCommand, ATableThatDoesNotMoveHasNoExpression) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("identity.csv"), mien::writeTable(mien::DeformationTable()));
  const Outcome outcome = runFdt({"classify", folder.file("identity.csv")});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.output.find("does not move"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.output.find("anger"), std::string::npos) << outcome.output;
  EXPECT_TRUE(json::parse(runFdt({"classify", folder.file("identity.csv"), "--json"}).output)["expression"].is_null());
}

TEST(FdtPackCommand, KeepsTheBoundItStates) {
  const TemporaryFolder folder;
  double before = 1.0;
  for (const char* const bits : {"8", "16"}) {
    const Outcome outcome = runFdt({"pack", "surprise", "--bits", bits, "-o", folder.file("p.fdt"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const json about = json::parse(outcome.output);
    EXPECT_EQ(about["bytes"], readTextFile(folder.file("p.fdt")).size());
    EXPECT_LE(about["generic_face_error_mm"], about["error_bound_mm"].get<double>() + 1e-5);
    EXPECT_LT(about["error_bound_mm"], before) << "more bits, less error";
    before = about["error_bound_mm"].get<double>() / 100.0;
    for (const char* const name : {"anger", "disgust", "fear", "joy", "sadness", "surprise"}) {
      const json packed =
          json::parse(runFdt({"pack", name, "--bits", bits, "-o", folder.file("p.fdt"), "--json"}).output);
      EXPECT_LE(packed["generic_face_error_mm"], packed["error_bound_mm"].get<double>() + 1e-5) << name;
      const Outcome named = runFdt({"classify", folder.file("p.fdt"), "--json"});
      EXPECT_EQ(json::parse(named.output)["expression"], name);
    }
  }
  EXPECT_EQ(runFdt({"pack", "joy", "--bits", "12", "-o", folder.file("q.fdt")}).exitCode, 2);
  EXPECT_EQ(runFdt({"pack", "joy", "-o", folder.file("q.csv")}).exitCode, 2);
}
