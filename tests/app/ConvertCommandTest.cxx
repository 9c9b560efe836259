#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "Program.h"

namespace {

const std::string demo = std::string(MIEN_DATA_DIR) + "/animation/demo.fap";
const std::string table = "time,EyeBlinkLeft,JawOpen,HeadYaw\n0,0,0,0\n0.1,1,0.5,0.1\n0.2,0,1,0.2\n";

Outcome convert(std::vector<std::string> options) {
  options.insert(options.begin(), "convert");
  return runMien(options);
}

std::string converted(const TemporaryFolder& folder, const std::string& from, const std::string& to,
                      std::vector<std::string> options = {}) {
  options.insert(options.begin(), {folder.file(from), "-o", folder.file(to)});
  const Outcome outcome = convert(options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return readTextFile(folder.file(to));
}

TEST(ConvertCommand, FAPsGoToATableAndBack) {
  const TemporaryFolder folder;
  ASSERT_EQ(convert({demo, "-o", folder.file("a.fap")}).exitCode, 0);
  EXPECT_EQ(converted(folder, "a.fap", "a.csv").rfind("# mien fap csv 1; fps=25;", 0), 0u);
  EXPECT_EQ(converted(folder, "a.csv", "b.fap"), readTextFile(folder.file("a.fap")));
}

TEST(ConvertCommand, CaptureIsSeenFromItsHeader) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), table);
  const std::string text = converted(folder, "take.csv", "take.fap");
  EXPECT_EQ(text.rfind("2.1 take.csv 10 3\n", 0), 0u) << text;
  const Outcome info = runMien({"info", folder.file("take.csv")});
  EXPECT_NE(info.output.find("ARKit blendshapes"), std::string::npos) << info.output;
  EXPECT_NE(info.output.find("3 at 10 per second"), std::string::npos) << info.output;
  EXPECT_EQ(runMien({"curves", "--fap", folder.file("take.csv"), "--index", "1", "-o", folder.file("c.csv")}).exitCode,
            0);
}

TEST(ConvertCommand, AnotherRateMixesFramesOrIsTheRateOfATableWithout) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), table);
  EXPECT_NE(converted(folder, "take.csv", "take.fap", {"--fps", "50"}).find(" 50 11\n"), std::string::npos);
  writeTextFile(folder.file("plain.csv"), "FAP3\n0\n100\n0\n");
  EXPECT_NE(converted(folder, "plain.csv", "plain.fap", {"--fps", "50"}).find(" 50 3\n"), std::string::npos);
}

/// The longest word of a text that is a fraction.
size_t longestFraction(const std::string& text) {
  std::istringstream words(text);
  size_t longest = 0;
  for (std::string word; words >> word;)
    if (const size_t dot = word.find('.');
        dot != std::string::npos && word.find_first_not_of("-.0123456789") == word.npos)
      longest = std::max(longest, word.size() - dot - 1);
  return longest;
}

TEST(ConvertCommand, ComputedValuesAreRoundedAndReadOnesAreNot) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), "time,EyeBlinkLeft,JawOpen,HeadYaw\n0,0.1,0.7,0.3\n0.1,0.333333,0.47,0.1\n");
  const std::string computed = converted(folder, "take.csv", "take.fap");
  EXPECT_GE(longestFraction(computed), 1u);
  EXPECT_LE(longestFraction(computed), 6u) << computed;
  EXPECT_LE(longestFraction(converted(folder, "take.fap", "mixed.fap", {"--fps", "17"})), 6u);
  writeTextFile(folder.file("read.csv"), "frame,time,FAP3\n0,0,0.1234567891234\n1,0.04,2\n");
  EXPECT_NE(converted(folder, "read.csv", "read.fap").find("0.1234567891234"), std::string::npos);
}

TEST(ConvertCommand, WhatIsLostIsSaid) {
  const TemporaryFolder folder;
  const Outcome outcome = convert({demo, "--to", "arkit", "-o", folder.file("a.csv")});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.errors.find("64 bend_nose"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("% of the movement is lost"), std::string::npos) << outcome.errors;
  const std::string back = converted(folder, "a.csv", "b.fap");
  EXPECT_NE(back.find(" 25 301\n"), std::string::npos);
}

TEST(ConvertCommand, VisemesAndExpressionsBecomeActions) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("a.csv"), "FAP2_expression_select1,FAP2_expression_intensity1\n1,63\n");
  for (const char* style : {"facs", "openface", "arkit"}) {
    const std::string text = converted(folder, "a.csv", "b.csv", {"--to", style});
    const std::string row = text.substr(text.find('\n') + 1);
    EXPECT_NE(row.find_first_of("123456789", row.find(',') + 4), std::string::npos) << style << ": joy moves something";
  }
}

TEST(ConvertCommand, StandardInputAndOutputArePipes) {
  const TemporaryFolder folder;
  const Outcome outcome = convert({demo, "-o", "-"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output.rfind("2.1 ", 0), 0u);
  EXPECT_EQ(outcome.errors, "");
}

TEST(ConvertCommand, ARateThatMakesTooManyFramesIsRefused) {
  const TemporaryFolder folder;
  const Outcome outcome = runMien(
      {"convert", std::string(MIEN_DATA_DIR) + "/animation/demo.fap", "--fps", "100000", "-o", folder.file("a.fap")});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_NE(outcome.errors.find("a million frames"), std::string::npos) << outcome.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

TEST(ConvertCommand, TheInputIsNeverReplaced) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), table);
  std::filesystem::create_symlink(folder.file("take.csv"), folder.file("link.csv"));
  for (const std::string& output : {folder.file("take.csv"), folder.file("./take.csv"), folder.file("link.csv")}) {
    const Outcome outcome = convert({folder.file("take.csv"), "-o", output});
    EXPECT_EQ(outcome.exitCode, 2) << output;
    EXPECT_NE(outcome.errors.find("which it would replace"), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(readTextFile(folder.file("take.csv")), table);
  const Outcome curves = runMien({"curves", "--fap", folder.file("take.csv"), "-o", folder.file("take.csv")});
  EXPECT_EQ(curves.exitCode, 2) << curves.errors;
  EXPECT_EQ(readTextFile(folder.file("take.csv")), table);
}

TEST(ConvertCommand, TheTimeCodeIsKeptOrGivenOrItsLossIsSaid) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), "Timecode,JawOpen\n10:59:58:13.217,0\n10:59:58:14.217,1\n");
  const Outcome lost = convert({folder.file("take.csv"), "-o", folder.file("a.fap")});
  EXPECT_EQ(lost.exitCode, 0);
  EXPECT_NE(lost.errors.find("10:59:58:13.217, has no place"), std::string::npos) << lost.errors;
  EXPECT_NE(converted(folder, "take.csv", "b.csv").find("; start=10:59:58:13.217;"), std::string::npos);
  EXPECT_NE(converted(folder, "b.csv", "c.csv", {"--to", "arkit"}).find("\n10:59:58:13.217,"), std::string::npos);
  EXPECT_NE(converted(folder, "a.fap", "d.csv", {"--to", "arkit", "--start", "10:00:00:30"}).find("\n10:00:00:30.000,"),
            std::string::npos);
  for (const char* start : {"noon", "25:00:00:00", "10:00:00;30", "10:00:00:60"})
    EXPECT_EQ(convert({folder.file("a.fap"), "--to", "arkit", "--start", start, "-o", folder.file("e.csv")}).exitCode,
              2)
        << start;
  EXPECT_EQ(convert({folder.file("a.fap"), "--start", "10:00:00:30", "-o", folder.file("e.fap")}).exitCode, 2);
}

TEST(ConvertCommand, TheMapOfOnesOwnIsToldAsAMap) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), table);
  writeTextFile(folder.file("bad.json"), "{\n\"format\": ,\n");
  const auto fault = [&](const std::string& map) {
    return convert({folder.file("take.csv"), "--map", folder.file(map), "-o", folder.file("a.fap")}).errors;
  };
  EXPECT_NE(fault("none.json").find("none.json: it cannot be opened; give a JSON file with the facial action map"),
            std::string::npos)
      << fault("none.json");
  EXPECT_NE(fault("bad.json").find("bad.json:2: facial action map: it is no valid JSON"), std::string::npos)
      << fault("bad.json");
  EXPECT_EQ(fault("bad.json").find("exception"), std::string::npos);
}

TEST(ConvertCommand, WrongFilesAndValuesAreRefused) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("take.csv"), "time,EyeBlinkLeft\n0,0\n0.1,x\n");
  writeTextFile(folder.file("other.csv"), "a,b\n1,2\n");
  const std::string out = folder.file("out.fap");
  const std::vector<std::tuple<std::vector<std::string>, int, std::string>> cases = {
      {{folder.file("take.csv"), "-o", out}, 1, "take.csv:3: column 2 ('EyeBlinkLeft') is 'x'; give a finite number"},
      {{folder.file("other.csv"), "-o", out}, 1, "other.csv:1: no column is known"},
      {{folder.file("other.csv"), "--from", "facs", "-o", out}, 1, "no column of an action unit"},
      {{folder.file("none.csv"), "-o", out}, 1, "cannot be opened"},
      {{folder.file(""), "-o", out}, 1, "folder"},
      {{demo, "-o", folder.file("out.txt")}, 2, "ending"},
      {{demo, "-o", out, "--to", "bvh"}, 2, "--to 'bvh'"},
      {{demo, "-o", out, "--from", "bvh"}, 2, "--from 'bvh'"},
      {{demo, "-o", out, "--fps", "0"}, 2, "--fps"},
      {{demo, "-o", out, "--map", demo}, 1, "facial action map"},
      {{demo, "-o", folder.file("no/out.fap")}, 1, "no folder"}};
  for (const auto& [options, code, words] : cases) {
    const Outcome outcome = convert(options);
    EXPECT_EQ(outcome.exitCode, code) << words << ": " << outcome.errors;
    EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(entriesIn(folder.file("")), 2);
}

}  // namespace
