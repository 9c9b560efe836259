#include <gtest/gtest.h>

#include <tuple>

#include "AnimationText.h"
#include "FAPCsvParser.h"
#include "FAPCsvWriter.h"
#include "FacialActions.h"

using namespace mien;

namespace {

FAPSequence parsedCsv(const std::string& text) {
  FAPSequence sequence;
  const auto error = parseFAPCsv(text, sequence);
  EXPECT_FALSE(error.has_value()) << error->line << ": " << error->message;
  return sequence;
}

}  // namespace

TEST(FAPCsv, ColumnsAreFoundByNumberAndByName) {
  const FAPSequence sequence = parsedCsv(
      "frame,time,FAP51,fap "
      "52,FAP53_stretch_l_cornerlip_o,stretch_r_cornerlip,Viseme_Select1,FAP2_expression_intensity1\n"
      "7,0,1,2,3,4,5,6\n8,0.1,1.5,-2,+3e1,,0,63\n");
  ASSERT_EQ(sequence.frames.size(), 2u);
  EXPECT_DOUBLE_EQ(sequence.framesPerSecond, 10.0);
  EXPECT_EQ(sequence.frames[0].number, 7.0);
  EXPECT_EQ(sequence.frames[0].value(51), 1.0);
  EXPECT_EQ(sequence.frames[0].value(52), 2.0);
  EXPECT_EQ(sequence.frames[0].value(53), 3.0);
  EXPECT_EQ(sequence.frames[0].value(7), 4.0);
  EXPECT_EQ(sequence.frames[0].viseme.select1, 5.0);
  EXPECT_EQ(sequence.frames[0].expression.intensity1, 6.0);
  EXPECT_EQ(sequence.frames[1].value(53), 30.0);
  EXPECT_TRUE(sequence.masks[0][6]);
  EXPECT_FALSE(sequence.masks[1][6]) << "an empty cell is a FAP that is not set";
}

TEST(FAPCsv, TheCommentGoesBeforeTheTimes) {
  const FAPSequence sequence =
      parsedCsv("# mine\r\n# mien fap csv 1; fps=29.97; version=2.0; name=a; b\r\n\"FAP3\" , \"FAP4\"\r\n1,2\r\n");
  EXPECT_EQ(sequence.framesPerSecond, 29.97);
  EXPECT_EQ(sequence.version, "2.0");
  EXPECT_EQ(sequence.name, "a; b");
  EXPECT_TRUE(sequence.warnings.empty());
}

TEST(FAPCsv, SemicolonsAndTabsSeparateToo) {
  EXPECT_EQ(parsedCsv("FAP3;FAP4;FAP5\n1;2;3\n").frames[0].value(5), 3.0);
  EXPECT_EQ(parsedCsv("FAP3\tFAP4\tFAP5\n1\t2\t3\n").frames[0].value(5), 3.0);
}

TEST(FAPCsv, WhatIsLeftOutOrAssumedIsSaid) {
  const FAPSequence sequence = parsedCsv("note,FAP3,FAP99\nhello,1,2\n");
  ASSERT_EQ(sequence.warnings.size(), 2u);
  EXPECT_NE(sequence.warnings[0].message.find("'note', 'FAP99'"), std::string::npos) << sequence.warnings[0].message;
  EXPECT_NE(sequence.warnings[1].message.find("25 frames per second are assumed"), std::string::npos);
  EXPECT_TRUE(sequence.rateIsAssumed);
}

TEST(FAPCsv, ATimeBesideATimeOrAnAbsurdValueIsRefused) {
  for (const auto& [text, line, words] :
       {std::tuple{"time,Time,FAP3\n0,0,1\n", 1, "column 2 ('Time') says again what column 1 ('time') says"},
        {"FAP3,fap 3\n0,0\n", 1, "column 1 ('FAP3')"},
        {"frame,FAP3\n0,1\n1,-1e30\n", 3, "column 2 ('FAP3') is '-1e30'; FAP values lie within +-1e6"},
        {"# mien fap csv 1; start=noon\nFAP3\n0\n", 1, "the start is 'noon'"}}) {
    FAPSequence sequence;
    const auto error = parseFAPCsv(text, sequence);
    ASSERT_TRUE(error.has_value()) << text;
    EXPECT_EQ(error->line, line) << text;
    EXPECT_NE(error->message.find(words), std::string::npos) << error->message;
  }
}

TEST(FAPCsv, TimesThatContradictTheRateAreWarnedOf) {
  const auto sequence = parsedCsv("# mien fap csv 1; fps=50\nframe,time,FAP51\n0,7,1\n1,7.029,2\n2,7.08,3\n3,7.12,4\n");
  EXPECT_EQ(sequence.framesPerSecond, 50.0);
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 5);
  EXPECT_EQ(sequence.warnings[0].message,
            "column 2 ('time') is 0.08 s behind the first, but by fps=50 this is 0.04 s; fps counts, so leave it out "
            "of line 1 if the times are right");
}

TEST(FAPCsv, FramesThatAreMissingAreWarnedOfAndWrittenWithoutTimes) {
  const auto sequence = parsedCsv("# mien fap csv 1; fps=10\nframe,FAP51\n0,1\n1,2\n10,3\n");
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_EQ(sequence.warnings[0].line, 5);
  EXPECT_EQ(sequence.warnings[0].message.rfind("frames 2 to 9 are missing", 0), 0u) << sequence.warnings[0].message;
  std::string text;
  EXPECT_EQ(writeFAPCsv(sequence, text), "");
  EXPECT_NE(text.find("\nframe,FAP51\n0,1\n1,2\n10,3\n"), std::string::npos) << text;
  EXPECT_EQ(parsedCsv("# mien fap csv 1; fps=10\nframe,time,FAP51\n4,0,1\n5,0.1,2\n").warnings.size(), 0u);
}

TEST(FAPCsv, OneTimedRowTellsNoRate) {
  const FAPSequence sequence = parsedCsv("time,FAP3\n2.5,1\n");
  ASSERT_EQ(sequence.warnings.size(), 1u);
  EXPECT_NE(sequence.warnings[0].message.find("a single time tells no rate"), std::string::npos);
  EXPECT_EQ(parsedCsv("frame\n1\n2\n").frames.size(), 2u) << "neutral frames need no column of a FAP";
}

TEST(AnimationText, WhatIsNoTableIsToldAsSuch) {
  const FacialActionMap map = bundledFacialActions();
  const auto fault = [&](const char* text) {
    FAPSequence sequence;
    const auto error = parseAnimation(text, std::nullopt, map, sequence);
    return error ? error->message : "";
  };
  EXPECT_NE(fault("").find("the file is empty"), std::string::npos) << fault("");
  EXPECT_NE(fault("\n \n").find("the file is empty"), std::string::npos);
  EXPECT_NE(fault("0,0.1,0.2\n1,0.1,0.3\n").find("the table has no header"), std::string::npos);
  EXPECT_EQ(
      fault("2.1 a,b 25 1\n"
            "0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 "
            "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n0 5\n"),
      "");
  FAPSequence mixed;
  ASSERT_FALSE(parseAnimation("FAP3,FAP4,AU12\n1,2,0.5\n", std::nullopt, map, mixed).has_value());
  EXPECT_NE(mixed.warnings.front().message.find("mixes kinds"), std::string::npos);
  EXPECT_NE(mixed.warnings.front().message.find("1 column of FACS action units"), std::string::npos);
}

TEST(AnimationText, EveryFormatIsRecognisedByItsFirstLines) {
  const FacialActionMap map = bundledFacialActions();
  const auto recognised = [&](const char* text) { return recogniseAnimation(text, map); };
  EXPECT_EQ(recognised("2.1 speech 25 1\n"), AnimationFormat::FAP);
  EXPECT_EQ(recognised("2.1\tspeech, long\t25\t1\n"), AnimationFormat::FAP);
  EXPECT_EQ(recognised("# a\n0 0 0 0 0\n"), AnimationFormat::FAP);
  EXPECT_EQ(recognised(""), AnimationFormat::FAP);
  EXPECT_EQ(recognised("frame,FAP3\n"), AnimationFormat::FAPCsv);
  EXPECT_EQ(recognised("# mien fap csv 1; fps=25\nframe,time\n"), AnimationFormat::FAPCsv);
  EXPECT_EQ(recognised("frame, face_id, timestamp, confidence, success, AU01_r, AU02_r\n"),
            AnimationFormat::ActionUnits);
  EXPECT_EQ(recognised("Timecode,BlendshapeCount,EyeBlinkLeft\n"), AnimationFormat::Blendshapes);
  EXPECT_EQ(recognised("a,b,c\n"), std::nullopt);
}
