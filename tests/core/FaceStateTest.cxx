#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <vector>

#include "FaceState.h"
#include "FaceStateText.h"

namespace {

using mien::FaceState;
using Change = std::function<void(FaceState&)>;

/// One change for every property; values that need all 17 digits.
const std::vector<Change> changes = {
    [](FaceState& s) { s.curvesFile = "a folder/Gesicht ä.vtp"; },
    [](FaceState& s) { s.edits = {mien::CurveEdit()}; },
    [](FaceState& s) {
      s.edits = {{22, 1.0 / 3.0, {0.1, -0.2, 0.3}, 0.7, 3, true}, {5, 2.9, {1.0, 2.0, 3.0}, 0.5, 0, false}};
    },
    [](FaceState& s) { s.surface.scheme = "derivative"; },
    [](FaceState& s) { s.surface.smoothing[8] = 0.1 + 0.2; },
    [](FaceState& s) { s.surface.modes = 7; },
    [](FaceState& s) { s.surface.remainder = false; },
    [](FaceState& s) { s.surface.derivativeStrength = -1.0 / 3.0; },
    [](FaceState& s) { s.rows = 83; },
    [](FaceState& s) { s.columns = 120; },
    [](FaceState& s) { s.uniformRows = true; },
    [](FaceState& s) { s.doublePrecision = true; },
    [](FaceState& s) { s.fapFile = "x.fap"; },
    [](FaceState& s) { s.fapFile = "x.fap", s.frame = 12; },
    [](FaceState& s) { s.fapFile = "x.fap", s.frameChoice = FaceState::FrameChoice::Number, s.frame = -40; },
    [](FaceState& s) { s.fapFile = "x.fap", s.frameChoice = FaceState::FrameChoice::Time, s.frame = 1.0 / 25.0; },
    [](FaceState& s) { s.fapFile = "x.fap", s.interpolateFrames = true; },
    [](FaceState& s) {
      s.fapValues = {{53, 200.5}, {54, -1e-300}};
    },
    [](FaceState& s) { s.animationTable = "my table.json"; },
    [](FaceState& s) {
      s.expressions = {{"joy", 0.8}, {"surprise", 1.0 / 3.0}};
    },
    [](FaceState& s) {
      s.visemes = {{"p b m", 0.25}, {"U", 1.0 / 3.0}};
    },
    [](FaceState& s) { s.deformation.table = "joy"; },
    [](FaceState& s) { s.deformation.strength = -0.1; },
    [](FaceState& s) { s.deformation.smooth = false; },
    [](FaceState& s) { s.texture = "Bild ä.png"; },
    [](FaceState& s) { s.textureMesh = "a mesh.csv"; },
    [](FaceState& s) { s.textureMesh = "mien_warp_mesh,1,4,4\nrow,column,x,y\n"; },
};

std::string faultOf(const Change& change, int pointsPerCurve = 40) {
  FaceState state;
  change(state);
  return mien::describeFault(state, pointsPerCurve);
}

TEST(FaceState, EveryPropertySurvivesItsTextForm) {
  for (size_t i = 0; i < changes.size(); ++i) {
    FaceState written, read;
    changes[i](written);
    ASSERT_NE(written, FaceState()) << "change " << i;
    EXPECT_EQ(mien::readFaceState(mien::writeFaceState(written), read), "");
    EXPECT_EQ(read, written) << "change " << i;
  }
}

TEST(FaceState, DefaultsAreSound) {
  EXPECT_EQ(mien::describeFault(FaceState(), 40), "");
}

TEST(FaceState, MembersLeftOutHaveTheirDefaults) {
  FaceState state;
  state.rows = 100;
  EXPECT_EQ(mien::readFaceState(R"({"mien_face_state": 2})", state), "");
  EXPECT_EQ(state, FaceState());
}

TEST(FaceState, BadTextIsRefusedAndLeavesTheStateAlone) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{", "no valid JSON"},
      {"[]", "no object"},
      {"{}", "mien_face_state"},
      {R"({"mien_face_state": 1})", "version 2"},
      {R"({"mien_face_state": 2, "hat": 3})", "'hat'"},
      {R"({"mien_face_state": 2, "grid": {"rows": 56.5}})", "'grid.rows'"},
      {R"({"mien_face_state": 2, "grid": {"rows": 1e300}})", "'grid.rows'"},
      {R"({"mien_face_state": 2, "grid": {"rows": 99999999999999}})", "'grid.rows'"},
      {R"({"mien_face_state": 2, "grid": {"precision": "half"}})", "'grid.precision'"},
      {R"({"mien_face_state": 2, "surface": 5})", "'surface'"},
      {R"({"mien_face_state": 2, "edits": 5})", "'edits'"},
      {R"({"mien_face_state": 2, "edits": [{"curve": "C99"}]})", "'edits[0].curve'"},
      {R"({"mien_face_state": 2, "edits": [{"curve": "C6", "move": [1, 2]}]})", "'edits[0].move'"},
      {R"({"mien_face_state": 2, "edits": [{"curve": "C6", "speed": 1}]})", "'edits[0].speed'"},
      {R"({"mien_face_state": 2, "surface": {"a": [1, 2]}})", "nine numbers"},
      {R"({"mien_face_state": 2, "surface": {"a": [1, 1, 1, 1, 1, 1, 1, 1, "x"]}})", "nine numbers"},
      {R"({"mien_face_state": 2, "surface": {"remainder": 1}})", "'surface.remainder'"},
      {R"({"mien_face_state": 2, "animation": {"file": "x", "index": 1, "time": 2}})", "more than one"},
      {R"({"mien_face_state": 2, "fap_values": {"5x": 1}})", "'fap_values.5x'"},
      {R"({"mien_face_state": 2, "expressions": {"joy": "much"}})", "'expressions.joy'"},
      {R"({"mien_face_state": 2, "expressions": [1]})", "'expressions'"},
      {R"({"mien_face_state": 2, "visemes": {"U": true}})", "'visemes.U'"},
      {R"({"mien_face_state": 2, "visemes": 3})", "'visemes'"},
      {R"({"mien_face_state": 2, "deformation": {"table": 4}})", "'deformation.table'"},
  };
  FaceState kept;
  kept.rows = 83;
  for (const auto& [text, part] : cases) {
    FaceState state = kept;
    EXPECT_NE(mien::readFaceState(text, state).find(part), std::string::npos)
        << text << " -> " << mien::readFaceState(text, state);
    EXPECT_EQ(state, kept);
  }
}

TEST(FaceState, ValuesOutOfRangeAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<Change, std::string>> cases = {
      {[](FaceState& s) { s.surface.scheme = "soap"; }, "four-curve"},
      {[](FaceState& s) { s.surface.smoothing[3] = 0; }, "a = 0"},
      {[](FaceState& s) { s.surface.modes = 21; }, "0 .. 20"},
      {[](FaceState& s) {
         s.surface.scheme = "four-curve";
         s.surface.smoothing.fill(50);
       },
       "250"},
      {[](FaceState& s) { s.rows = 10; }, "at least 11x3"},
      {[](FaceState& s) { s.columns = 2; }, "at least 11x3"},
      {[](FaceState& s) { s.rows = s.columns = 2000000000; }, "too fine"},
      {[nan](FaceState& s) { s.frame = nan; }, "finite"},
      {[](FaceState& s) { s.frame = 0.5; }, "whole number"},
      {[](FaceState& s) { s.frameChoice = FaceState::FrameChoice::Time, s.frame = -1; }, "before the first"},
      {[](FaceState& s) { s.fapValues[2] = 1; }, "3 .. 68"},
      {[](FaceState& s) { s.fapValues[69] = 1; }, "3 .. 68"},
      {[nan](FaceState& s) { s.fapValues[53] = nan; }, "FAP 53"},
      {[](FaceState& s) { s.expressions["joy"] = 1.1; }, "0 .. 1"},
      {[nan](FaceState& s) { s.expressions["joy"] = nan; }, "0 .. 1"},
      {[](FaceState& s) { s.visemes["U"] = -0.1; }, "0 .. 1"},
      {[](FaceState& s) {
         s.visemes = {{"U", 0.2}, {"I", 0.2}, {"e", 0.2}};
       },
       "3 visemes"},
      {[](FaceState& s) { s.deformation.strength = 2.5; }, "-2 .. 2"},
  };
  for (const auto& [change, part] : cases) EXPECT_NE(faultOf(change).find(part), std::string::npos) << faultOf(change);
}

}  // namespace
