#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "FAPParser.h"
#include "FAPWriter.h"

using namespace mien;

namespace {

FAPSequence randomSequence(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(-1500.0, 1500.0);
  FAPSequence sequence;
  sequence.name = "made up";
  sequence.framesPerSecond = 29.97;
  sequence.frames.resize(count);
  for (FAPFrame& frame : sequence.frames) {
    frame.number = value(random);
    frame.viseme = {double(random() % 15), double(random() % 15), 31.0 / 3.0, double(random() % 2)};
    frame.expression = {double(random() % 7), 63.0, double(random() % 7), 1.0 / 3.0, double(random() % 2), 1.0};
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      if (random() % 2) frame.setValue(fap, value(random) * std::pow(10.0, int(random() % 13) - 10));
  }
  return sequence;
}

void expectSameHighLevel(const FAPFrame& a, const FAPFrame& b) {
  EXPECT_EQ(a.viseme.select1, b.viseme.select1);
  EXPECT_EQ(a.viseme.select2, b.viseme.select2);
  EXPECT_EQ(a.viseme.blend, b.viseme.blend);
  EXPECT_EQ(a.viseme.definition, b.viseme.definition);
  EXPECT_EQ(a.expression.select1, b.expression.select1);
  EXPECT_EQ(a.expression.intensity1, b.expression.intensity1);
  EXPECT_EQ(a.expression.select2, b.expression.select2);
  EXPECT_EQ(a.expression.intensity2, b.expression.intensity2);
  EXPECT_EQ(a.expression.initialFace, b.expression.initialFace);
  EXPECT_EQ(a.expression.definition, b.expression.definition);
}

}  // namespace

TEST(FAPWriter, EveryValueComesBackExactly) {
  const FAPSequence sequence = randomSequence(200);
  std::string text;
  ASSERT_EQ(writeFAP(sequence, text), "");
  FAPSequence read;
  const auto error = parseFAP(text, read);
  ASSERT_FALSE(error.has_value()) << error->line << ": " << error->message;
  EXPECT_EQ(read.version, "2.1");
  EXPECT_EQ(read.name, "made up");
  EXPECT_EQ(read.framesPerSecond, 29.97);
  EXPECT_EQ(read.declaredFrameCount, 200);
  ASSERT_EQ(read.frames.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_EQ(read.frames[i].number, sequence.frames[i].number);
    expectSameHighLevel(read.frames[i], sequence.frames[i]);
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      ASSERT_EQ(read.frames[i].value(fap), sequence.frames[i].value(fap));
  }
}

TEST(FAPWriter, NumbersAreAsShortAsTheyCanBe) {
  FAPSequence sequence;
  sequence.name = "short";
  sequence.frames.resize(1);
  sequence.frames[0].setValue(53, 0.1);
  sequence.frames[0].setValue(54, 200.0);
  std::string text;
  ASSERT_EQ(writeFAP(sequence, text), "");
  EXPECT_EQ(text.substr(0, text.find('\n')), "2.1 short 25 1");
  EXPECT_EQ(text.substr(text.size() - 11), "\n0 0.1 200\n");
}

TEST(FAPWriter, MasksOfTheFileAreKeptAndNonZeroValuesAreNeverLost) {
  FAPSequence sequence;
  sequence.frames.resize(1);
  sequence.masks.resize(1);
  sequence.masks[0].set(18);
  sequence.frames[0].setValue(53, 5.0);
  std::string text;
  ASSERT_EQ(writeFAP(sequence, text), "");
  FAPSequence read;
  ASSERT_FALSE(parseFAP(text, read).has_value());
  EXPECT_EQ(read.fapsUsed(), (std::vector<int>{19, 53}));
  EXPECT_EQ(read.frames[0].value(53), 5.0);
}

TEST(FAPWriter, NamesCannotBreakTheHeader) {
  const std::string long1(longestFAPLine, 'x'), long2 = std::string(1023, 'x') + " y";
  for (const std::string& name :
       {std::string(), std::string("  "), std::string("a\nb\r\tc"), std::string("# no comment"), std::string("25 1"),
        std::string("\x01"), long1, long2}) {
    FAPSequence sequence = randomSequence(1);
    sequence.name = name;
    std::string text;
    ASSERT_EQ(writeFAP(sequence, text), "");
    FAPSequence read;
    ASSERT_FALSE(parseFAP(text, read).has_value()) << name;
    EXPECT_FALSE(read.name.empty());
    EXPECT_TRUE(read.warnings.empty());
    EXPECT_EQ(read.framesPerSecond, 29.97);
  }
}

TEST(FAPWriter, RefusesWhatCouldNotBeReadAndLeavesTheText) {
  std::string text = "before";
  EXPECT_NE(writeFAP(FAPSequence(), text).find("no frames"), std::string::npos);
  FAPSequence sequence = randomSequence(3);
  sequence.frames[2].setValue(9, std::numeric_limits<double>::infinity());
  EXPECT_NE(writeFAP(sequence, text).find("frame 2"), std::string::npos);
  sequence = randomSequence(1);
  sequence.framesPerSecond = 0.0;
  EXPECT_NE(writeFAP(sequence, text).find("rate"), std::string::npos);
  EXPECT_EQ(text, "before");
}
