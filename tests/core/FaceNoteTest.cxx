#include <gtest/gtest.h>

#include "FaceNote.h"

using namespace mien;

TEST(FaceNote, NamesEveryPartOfTheState) {
  FaceState state;
  EXPECT_EQ(motionText(state), "");
  const std::string rest = faceNote(state, {"spline"});
  EXPECT_EQ(rest.rfind("Generic face, scheme spline; a = 1; N = 5 with remainder; Mien ", 0), 0u) << rest;
  state.fapFile = "/data/talk.fap";
  state.frameChoice = FaceState::FrameChoice::Number;
  state.frame = 5.0;
  state.fapValues[3] = 300.0;
  EXPECT_EQ(motionText(state), "frame 5 of talk.fap, FAP 3 = 300");
  state.expressions = {{"joy", 1.0}, {"surprise", 0.25}};
  state.visemes = {{"p b m", 0.5}};
  state.deformation.table = "tables/smile.csv";
  state.deformation.strength = 0.5;
  EXPECT_EQ(motionText(state, "frames 5, 9"),
            "frames 5, 9 of talk.fap, joy, surprise at 0.25, viseme p b m at 0.5, FAP 3 = 300, deformation table "
            "smile.csv at 0.5");
  EXPECT_EQ(motionText(state, "frame 5", 0).find("FAP 3"), std::string::npos);
  state.animationTable = "own.json";
  state.edits.emplace_back();
  state.surface.smoothing[4] = 7.0;
  const std::string note = faceNote(state, {"spline", "tangent"});
  for (const char* const part : {"1 edit of curves", "schemes spline, tangent", "a = 1, 1, 1, 1, 7, 1, 1, 1, 1",
                                 "own.json", "frame 5 of talk.fap", "FAP 3 = 300"})
    EXPECT_NE(note.find(part), std::string::npos) << part << ": " << note;
  EXPECT_EQ(faceNote(state, {"spline"}, false).find("a ="), std::string::npos);
}
