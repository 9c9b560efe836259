#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <random>
#include <tuple>

#include "CaptureParser.h"
#include "CaptureWriter.h"
#include "FAPCsvParser.h"
#include "FAPCsvWriter.h"
#include "FacialActions.h"
#include "TimeCode.h"

using namespace mien;

namespace {

FAPSequence parsed(const std::string& text, CaptureKind kind) {
  FAPSequence sequence;
  const auto error = parseCapture(text, kind, bundledFacialActions(), sequence);
  EXPECT_FALSE(error.has_value()) << error->line << ": " << error->message;
  return sequence;
}

FAPSequence blendshapes(const std::string& text) {
  return parsed(text, CaptureKind::Blendshapes);
}
FAPSequence actionUnits(const std::string& text) {
  return parsed(text, CaptureKind::ActionUnits);
}

/// Rows of Live Link Face: a blink that closes over the frames.
std::string liveLink(int rows, int timeCodeRate, int step) {
  std::string text = "Timecode,BlendshapeCount,EyeBlinkLeft,EyeBlinkRight,HeadYaw\n";
  for (int row = 0; row < rows; ++row) {
    const int frame = 13 + row * step;
    char line[80];
    std::snprintf(line, sizeof line, "10:59:%02d:%02d.%03d,61,%g,0,0.25\n", 58 + frame / timeCodeRate % 2,
                  frame % timeCodeRate, 217, row / (rows - 1.0));
    text += line;
  }
  return text;
}

bool warns(const FAPSequence& sequence, const std::string& words) {
  return std::any_of(sequence.warnings.begin(), sequence.warnings.end(),
                     [&](const FAPWarning& warning) { return warning.message.find(words) != std::string::npos; });
}

}  // namespace

TEST(CaptureParser, TimeCodesDecideTheRate) {
  EXPECT_DOUBLE_EQ(blendshapes(liveLink(90, 60, 1)).framesPerSecond, 60.0);
  EXPECT_DOUBLE_EQ(blendshapes(liveLink(30, 60, 2)).framesPerSecond, 30.0);
  EXPECT_DOUBLE_EQ(blendshapes(liveLink(40, 30, 1)).framesPerSecond, 30.0);
  EXPECT_DOUBLE_EQ(blendshapes(liveLink(30, 25, 1)).framesPerSecond, 25.0);
  const FAPSequence brief = blendshapes(liveLink(20, 60, 1));
  EXPECT_DOUBLE_EQ(brief.framesPerSecond, 60.0);
  EXPECT_TRUE(warns(brief, "full second"));
  const FAPSequence dropped = blendshapes(
      "Timecode,EyeBlinkLeft\n01:00:00;00,0\n01:00:00;01,0\n01:00:00;28,0\n01:00:00;29,0\n01:00:01;00,0\n01:00:01;01,"
      "0\n");
  EXPECT_NEAR(dropped.framesPerSecond, 30000.0 / 1001.0, 1e-9);
}

/// A camera's own clock beside that of the time code: fractions of a frame anywhere within it.
TEST(CaptureParser, JitteredTimeCodesCountTheirFrames) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> fraction(0, 999);
  for (const int base : {30, 60}) {
    std::string text = "Timecode,BlendshapeCount,JawOpen\n";
    for (int row = 0; row < 120; ++row) {
      const int frame = 17 + row;
      char line[64];
      std::snprintf(line, sizeof line, "10:59:%02d:%02d.%03d,61,0.5\n", 40 + frame / base, frame % base,
                    fraction(random));
      text += line;
    }
    const FAPSequence sequence = blendshapes(text);
    EXPECT_DOUBLE_EQ(sequence.framesPerSecond, base);
    EXPECT_EQ(sequence.frames.size(), 120u) << base;
    EXPECT_TRUE(sequence.warnings.empty()) << base << ": " << sequence.warnings[0].message;
  }
}

TEST(CaptureParser, TheTimeCodeOfTheFirstFrameIsKept) {
  const FAPSequence sequence = blendshapes(liveLink(90, 60, 1));
  EXPECT_EQ(timeCodeText(sequence.startTime), "10:59:58:13.217");
  std::string text;
  ASSERT_EQ(writeFAPCsv(sequence, text), "");
  FAPSequence table;
  ASSERT_FALSE(parseFAPCsv(text, table).has_value());
  EXPECT_EQ(timeCodeText(table.startTime), "10:59:58:13.217");
  CaptureLoss loss;
  ASSERT_EQ(writeCapture(table, CaptureStyle::LiveLinkFace, bundledFacialActions(), text, loss), "");
  EXPECT_NE(text.find("\n10:59:58:13.217,"), std::string::npos);
  const FAPSequence single = blendshapes("Timecode,JawOpen\n10:59:58:13.217,1\n");
  EXPECT_DOUBLE_EQ(single.framesPerSecond, 60.0);
  EXPECT_FALSE(warns(single, "25 frames"));
  EXPECT_TRUE(warns(single, "60 frames per second"));
}

TEST(CaptureParser, EyeRotationsCountWhereNoShapeTurnsTheEye) {
  const std::string angles = "LeftEyeYaw,LeftEyePitch,RightEyeYaw,RightEyePitch";
  const FAPFrame alone = blendshapes("JawOpen," + angles + "\n0,0.3,0.1,-0.2,0.05\n").frames[0];
  EXPECT_DOUBLE_EQ(alone.value(23), 30000.0);
  EXPECT_DOUBLE_EQ(alone.value(25), -10000.0) << "positive is up";
  EXPECT_DOUBLE_EQ(alone.value(24), -20000.0);
  EXPECT_DOUBLE_EQ(alone.value(26), -5000.0);
  const FAPFrame still = blendshapes("EyeLookOutLeft,EyeLookInLeft," + angles + "\n0,0,0.3,0,0,0\n").frames[0];
  EXPECT_DOUBLE_EQ(still.value(23), 30000.0) << "shapes that stay 0 say nothing";
  const FAPFrame shaped = blendshapes("EyeLookOutLeft,EyeLookInLeft," + angles + "\n0.5,0,0.3,0,0,0\n").frames[0];
  EXPECT_DOUBLE_EQ(shaped.value(23), 30000.0) << "the shape alone: both would turn it twice";
  EXPECT_TRUE(warns(blendshapes("JawOpen,LeftEyeRoll\n0,0.1\n"), "LeftEyeRoll"));
  FAPSequence sequence;
  EXPECT_TRUE(parseCapture("JawOpen,HeadYaw\n0,1e30\n", CaptureKind::Blendshapes, bundledFacialActions(), sequence));
}

TEST(CaptureParser, TwoColumnsOfOneMeaningAreRefusedByName) {
  const FacialActionMap map = bundledFacialActions();
  for (const auto& [header, first, second] : {std::tuple{"EyeBlinkLeft,eyeBlink_L", "EyeBlinkLeft", "eyeBlink_L"},
                                              {"AU2,AU2L,AU2R", "AU2", "AU2L"},
                                              {"AU02_r,AU2_r", "AU02_r", "AU2_r"},
                                              {"AU1,JawOpen,frame,Frame", "'frame'", "Frame"},
                                              {"AU1,JawOpen,time,timestamp", "'time'", "timestamp"},
                                              {"AU1,JawOpen,HeadYaw,headYaw", "HeadYaw", "headYaw"}})
    for (const CaptureKind kind : {CaptureKind::ActionUnits, CaptureKind::Blendshapes}) {
      const auto columns = std::count(header, header + std::strlen(header), ',');
      std::string text = std::string(header) + "\n0";
      for (long i = 0; i < columns; ++i) text += ",0";
      FAPSequence sequence;
      const auto error = parseCapture(text + "\n", kind, map, sequence);
      ASSERT_TRUE(error.has_value()) << header;
      if (error->message.find("there is no column of") == 0) continue;  // of the other kind
      EXPECT_NE(error->message.find(first), std::string::npos) << error->message;
      EXPECT_NE(error->message.find(second), std::string::npos) << error->message;
      EXPECT_EQ(error->line, 1);
    }
}

TEST(CaptureParser, FrameNumbersOutliveLostRows) {
  std::string text = "frame,timestamp,success,AU45_r\n";
  for (int row = 0; row < 90; ++row) {
    const bool lost = row >= 40 && row < 45;
    char line[64];
    std::snprintf(line, sizeof line, "%d,%.3f,%d,1\n", row + 1, row / 30.0, lost ? 0 : 1);
    text += line;
  }
  const FAPSequence sequence = actionUnits(text);
  ASSERT_EQ(sequence.frames.size(), 90u);
  for (int i = 0; i < 90; ++i) EXPECT_NEAR(sequence.frames[i].number, i + 1.0, 1e-9);
  EXPECT_TRUE(warns(sequence, "5 rows without a face"));
  EXPECT_EQ(sequence.warnings.size(), 1u) << "bridged rows are no uneven timing";
}

TEST(CaptureParser, OneSlipDoesNotChangeTheScale) {
  const FAPSequence slip = blendshapes("time,JawOpen,EyeBlinkLeft\n0,0.5,0.2\n0.1,2.5,0.2\n0.2,0.5,0.2\n");
  EXPECT_DOUBLE_EQ(slip.frames[0].value(3), 300.0);
  EXPECT_DOUBLE_EQ(slip.frames[1].value(3), 600.0);
  EXPECT_TRUE(warns(slip, "limited"));
  EXPECT_FALSE(warns(slip, "per cent"));
  EXPECT_TRUE(warns(blendshapes("time,JawOpen,EyeBlinkLeft\n0,50,20\n"), "per cent"));
  EXPECT_TRUE(warns(actionUnits("AU1,AU2\n2.5,0\n5,0\n"), "0 .. 5"));
}

TEST(CaptureParser, StrengthsScaleTheMapAndTheHeadTurnsInRadians) {
  const FAPSequence sequence = blendshapes(liveLink(90, 60, 1));
  ASSERT_EQ(sequence.frames.size(), 90u);
  EXPECT_EQ(sequence.frames[0].value(19), 0.0);
  EXPECT_DOUBLE_EQ(sequence.frames[89].value(19), 940.0);
  EXPECT_DOUBLE_EQ(sequence.frames[89].value(21), 200.0);
  EXPECT_EQ(sequence.frames[89].value(20), 0.0);
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(49), 25000.0);
  EXPECT_TRUE(sequence.masks[0][19 - 1] && sequence.masks[0][49 - 1]);
}

TEST(CaptureParser, SpellingsOfBlendshapesGiveTheSame) {
  const FAPFrame frame = blendshapes("time,eyeBlinkLeft,jawOpen\n0,0.5,0.25\n").frames[0];
  for (const char* header :
       {"EyeBlinkLeft,JawOpen", "eyeBlink_L,jawOpen", "blendShape.eyeBlinkLeft,blendShape.jawOpen"}) {
    const FAPFrame other = blendshapes(std::string("time,") + header + "\n0,0.5,0.25\n").frames[0];
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      EXPECT_EQ(other.value(fap), frame.value(fap));
  }
  EXPECT_DOUBLE_EQ(blendshapes("eyeBlinkLeft,jawOpen\n50,25\n").frames[0].value(19), frame.value(19)) << "per cent";
}

TEST(CaptureParser, OpenFaceIntensitiesAreFullAtFive) {
  const FAPSequence sequence = actionUnits(
      "frame, face_id, timestamp, confidence, success, pose_Rx, pose_Ry, pose_Rz, AU12_r, AU45_r, AU12_c, AU28_c, "
      "gaze_0_x\n"
      "1, 0, 0.000, 0.98, 1, 0.1, 0.2, 0.3, 2.5, 5.00, 1.00, 0.00, 0\n"
      "2, 0, 0.033, 0.98, 1, 0, 0, 0, 0, 0, 0, 1, 0\n"
      "3, 0, 0.067, 0.98, 1, 0, 0, 0, 0, 0, 0, 1, 0\n"
      "4, 0, 0.100, 0.98, 1, 0, 0, 0, 0, 0, 0, 1, 0\n");
  EXPECT_DOUBLE_EQ(sequence.framesPerSecond, 30.0);
  ASSERT_EQ(sequence.frames.size(), 4u);
  EXPECT_EQ(sequence.frames[0].number, 1.0);
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(53), 75.0) << "half of AU12, whose presence does not count twice";
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(19), 940.0 + 31.0 * 0.0);
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(48), 10000.0) << "positive is down";
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(49), -20000.0) << "positive is to the subject's right";
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(50), -30000.0);
  EXPECT_DOUBLE_EQ(sequence.frames[1].value(16), -300.0) << "AU28 is there as a presence only";
  EXPECT_TRUE(warns(sequence, "gaze_0_x"));
}

TEST(CaptureParser, PlainActionUnitsAreFullAtOneOrFive) {
  EXPECT_DOUBLE_EQ(actionUnits("AU1L,AU1R,AU2R\n0.5,0,1\n").frames[0].value(31), 120.0);
  EXPECT_DOUBLE_EQ(actionUnits("AU1L,AU1R,AU2R\n0.5,0,1\n").frames[0].value(36), 270.0);
  EXPECT_DOUBLE_EQ(actionUnits("AU1_l,AU1_r,AU2\n0.5,1,0\n").frames[0].value(32), 240.0) << "_r beside _l is a side";
  EXPECT_DOUBLE_EQ(actionUnits("AU1,AU2\n2.5,0\n5,0\n").frames[0].value(31), 120.0);
}

TEST(CaptureParser, LostFacesAreBridgedAndOthersLeftOut) {
  const FAPSequence lost = blendshapes(
      "Timecode,BlendshapeCount,JawOpen\n00:00:00:00,61,0\n00:00:00:01,0\n00:00:00:02,61,1\n00:00:00:03,61,1\n00:00:00:"
      "04,61,1\n00:00:00:05,61,1\n00:00:00:59,61,1\n"
      "00:00:01:00,61,1\n");
  ASSERT_EQ(lost.frames.size(), 61u);
  EXPECT_DOUBLE_EQ(lost.frames[1].value(3), 300.0) << "half way between the frames around it";
  EXPECT_TRUE(warns(lost, "without a face"));
  EXPECT_TRUE(warns(lost, "1 gap)"));
  const FAPSequence two =
      actionUnits("face_id,timestamp,success,AU45_r\n3,0,1,0\n7,0,1,5\n3,0.04,1,5\n3,0.08,0,nan\n3,0.12,1,5\n");
  ASSERT_EQ(two.frames.size(), 4u);
  EXPECT_EQ(two.framesPerSecond, 25.0);
  EXPECT_EQ(two.frames[0].value(19), 0.0);
  EXPECT_DOUBLE_EQ(two.frames[2].value(19), 940.0);
  EXPECT_TRUE(warns(two, "other faces"));
}

TEST(CaptureParser, MidnightPassesAndRepeatedTimesAreLeftOut) {
  const FAPSequence midnight =
      blendshapes("Timecode,JawOpen\n23:59:59:58.0,0\n23:59:59:59.0,0\n00:00:00:00.0,1\n00:00:00:01.0,1\n");
  EXPECT_EQ(midnight.frames.size(), 4u);
  EXPECT_DOUBLE_EQ(midnight.framesPerSecond, 60.0);
  const FAPSequence repeated = blendshapes("time,JawOpen\n0,0\n0.04,0\n0.04,1\n0.08,1\n");
  EXPECT_EQ(repeated.frames.size(), 3u);
  EXPECT_TRUE(warns(repeated, "repeat a time"));
}

TEST(CaptureParser, StrengthsBeyondFullAreLimitedAndSaid) {
  const FAPSequence sequence = blendshapes("time,JawOpen,EyeBlinkLeft\n0,1.2,-0.1\n");
  EXPECT_DOUBLE_EQ(sequence.frames[0].value(3), 600.0);
  EXPECT_EQ(sequence.frames[0].value(19), 0.0);
  EXPECT_TRUE(warns(sequence, "limited"));
}
