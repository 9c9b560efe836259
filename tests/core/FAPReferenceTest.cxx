#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "FAPCsvParser.h"
#include "FAPCsvWriter.h"
#include "FAPFields.h"
#include "FAPParser.h"
#include "FAPTable.h"
#include "FAPWriter.h"
#include "QuotedCells.h"
#include "ReferenceData.h"
#include "TextFile.h"

using namespace mien;

namespace {

struct Expected {
  const char* file;
  const char* version;
  const char* name;
  double framesPerSecond;
  std::size_t frames, fapsUsed;
  std::size_t warnings;
};

const Expected expectations[] = {
    {"7_basic_emotion.fap", "2.1", "Xface::FapFile", 25, 7, 36, 0},
    {"basic_emotion.fap", "2.1", "Xface::FapFile", 25, 13, 36, 0},
    {"AU Interpolation_1111.fap", "2.1", "AU Interpolation_1111.fap", 25, 1, 4, 1},
    {"AU Interpolation_1122.fap", "2.1", "AU Interpolation_1122.fap", 25, 1, 4, 1},
    {"AU Interpolation_1130.fap", "2.1", "AU Interpolation_1130.fap", 25, 1, 4, 1},
    {"AU Interpolation_1213.fap", "2.1", "AU Interpolation_1213.fap", 25, 1, 4, 1},
    {"AU Interpolation_1248.fap", "2.1", "AU Interpolation_1248.fap", 25, 1, 4, 1},
    {"bari21_1.fap", "2.1", "C:\\code\\OOGreta\\Debug\\input\\bari21_1", 25, 408, 52, 0},
    {"empty.fap", "2.1", "empty", 25, 1, 0, 0},
    {"vreng_anger.fap", "2.1", "anger.fap", 10, 23, 18, 0},
    {"vreng_jag.fap", "2.0", "jag", 5, 169, 66, 0},
    {"vreng_joy.fap", "2.1", "joy.fap", 10, 20, 18, 0},
    {"xface_anger.fap", "2.1", "C:\\Users\\balci\\Work\\FACE\\exml2fap\\files\\TempFile", 25, 108, 48, 0},
    {"xface_joy.fap", "2.1", "C:\\Users\\balci\\Work\\FACE\\exml2fap\\files\\TempFile", 25, 108, 42, 0}};

FAPSequence readReference(const char* file) {
  FAPSequence sequence;
  const auto error = parseFAP(readTextFile(referencePath(std::string("faps/") + file)), sequence);
  EXPECT_FALSE(error.has_value()) << file << ":" << error->line << ": " << error->message;
  return sequence;
}

bool sameHighLevel(const FAPFrame& a, const FAPFrame& b) {
  std::vector<double> values[2];
  visitHighLevelFields(a, [&](const char*, double value) { values[0].push_back(value); });
  visitHighLevelFields(b, [&](const char*, double value) { values[1].push_back(value); });
  return values[0] == values[1];
}

/// Frames with their numbers, all fields of FAP 1 and 2, masks, rate and name.
void expectSame(const FAPSequence& second, const FAPSequence& first, const char* file) {
  EXPECT_EQ(second.name, first.name) << file;
  EXPECT_EQ(second.framesPerSecond, first.framesPerSecond) << file;
  EXPECT_EQ(second.masks, first.masks) << file;
  ASSERT_EQ(second.frames.size(), first.frames.size()) << file;
  for (std::size_t i = 0; i < first.frames.size(); ++i) {
    ASSERT_EQ(second.frames[i].number, first.frames[i].number) << file << " " << i;
    ASSERT_TRUE(sameHighLevel(second.frames[i], first.frames[i])) << file << " " << i;
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      ASSERT_EQ(second.frames[i].value(fap), first.frames[i].value(fap)) << file << " " << i;
  }
}

}  // namespace

TEST(FAPReference, EveryFileReadsWithWhatItHolds) {
  MIEN_REQUIRE_REFERENCE("faps");
  for (const Expected& expected : expectations) {
    const FAPSequence sequence = readReference(expected.file);
    EXPECT_EQ(sequence.version, expected.version) << expected.file;
    EXPECT_EQ(sequence.name, expected.name) << expected.file;
    EXPECT_EQ(sequence.framesPerSecond, expected.framesPerSecond) << expected.file;
    EXPECT_EQ(sequence.frames.size(), expected.frames) << expected.file;
    EXPECT_EQ(sequence.fapsUsed().size(), expected.fapsUsed) << expected.file;
    EXPECT_EQ(sequence.warnings.size(), expected.warnings) << expected.file;
  }
}

TEST(FAPReference, ValuesAreThoseOfTheFile) {
  MIEN_REQUIRE_REFERENCE("faps");
  const FAPSequence anger = readReference("7_basic_emotion.fap");
  EXPECT_EQ(anger.frames[0].value(4), -154.8);
  EXPECT_EQ(anger.frames[0].value(5), -44.8);
  const FAPSequence lids = readReference("AU Interpolation_1213.fap");
  EXPECT_EQ(lids.frames[0].value(19), 626.0);
  EXPECT_EQ(lids.frames[0].value(22), 133.0);
  const FAPSequence last = readReference("vreng_joy.fap");
  EXPECT_EQ(last.frames[19].value(60), 115.0);
}

TEST(FAPReference, WritingAndReadingAgainChangesNothing) {
  MIEN_REQUIRE_REFERENCE("faps");
  for (const Expected& expected : expectations) {
    const FAPSequence first = readReference(expected.file);
    std::string text;
    ASSERT_EQ(writeFAP(first, text), "") << expected.file;
    FAPSequence second;
    ASSERT_FALSE(parseFAP(text, second).has_value()) << expected.file;
    expectSame(second, first, expected.file);
    std::string again;
    ASSERT_EQ(writeFAP(second, again), "");
    EXPECT_EQ(again, text) << expected.file;
  }
}

TEST(FAPReference, AsATableAndBackTheFramesAreTheSame) {
  MIEN_REQUIRE_REFERENCE("faps");
  for (const Expected& expected : expectations) {
    const FAPSequence first = readReference(expected.file);
    std::string text;
    ASSERT_EQ(writeFAPCsv(first, text), "") << expected.file;
    FAPSequence second;
    const auto error = parseFAPCsv(text, second);
    ASSERT_FALSE(error.has_value()) << expected.file << ":" << error->line << ": " << error->message;
    EXPECT_EQ(second.version, first.version) << expected.file;
    EXPECT_TRUE(second.warnings.empty()) << expected.file;
    expectSame(second, first, expected.file);
  }
}

TEST(FAPReference, TheTableAgreesWithTheListOfFAPs) {
  MIEN_REQUIRE_REFERENCE("mpeg4/faps.csv");
  std::istringstream lines(readTextFile(referencePath("mpeg4/faps.csv")));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    const std::vector<std::string> cell = quotedCells(line);
    const FAPDefinition& fap = fapDefinition(std::stoi(cell[0]));
    EXPECT_EQ(fap.name, cell[1]);
    EXPECT_EQ(symbol(fap.unit), cell[3] == "na" ? "" : cell[3]) << cell[1];
    EXPECT_EQ(fap.bidirectional, cell[4] == "B") << cell[1];
    EXPECT_EQ(std::to_string(fap.group), cell[6]) << cell[1];
    EXPECT_EQ(fap.featurePoint, cell[7] == "na" ? "" : cell[7].substr(0, cell[7].find(';'))) << cell[1];
    EXPECT_EQ(std::to_string(fap.mirrorPartner), cell[10].empty() ? cell[0] : cell[10]) << cell[1];
    EXPECT_EQ(std::to_string(fap.mirrorSign), cell[11].empty() ? "1" : cell[11]) << cell[1];
    EXPECT_EQ(fap.inPaperSubset, cell[12] == "yes") << cell[1];
  }
  EXPECT_EQ(rows, FAPFrame::count);
}
