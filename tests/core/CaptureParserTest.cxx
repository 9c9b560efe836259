#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "CaptureParser.h"
#include "FacialActions.h"

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
  EXPECT_TRUE(warns(lost, "gaps"));
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
