#include <gtest/gtest.h>

#include "FaceArguments.h"
#include "FaceState.h"
#include "FaceStateText.h"

namespace {

using mien::FaceState;
using Words = std::vector<std::string>;

TEST(FaceArguments, OfTheNeutralFaceAreItsMeshAlone) {
  EXPECT_EQ(mien::faceArguments(FaceState()), (Words{"--resolution", "56x40"}));
}

TEST(FaceArguments, SayWhatDiffersFromTheStart) {
  FaceState state;
  state.surface.scheme = "tangent";
  state.surface.smoothing.fill(0.1);
  state.fapFile = "talk.fap";
  state.frame = 100000;
  state.fapValues = {{31, 100.5}, {53, -20}};
  state.visemes = {{"p b m", 0.25}};
  state.deformation = {"joy", -0.5, false};
  EXPECT_EQ(mien::faceArguments(state),
            (Words{"--scheme", "tangent", "-a", "0.1", "--resolution", "56x40", "--fap", "talk.fap", "--index",
                   "100000", "--viseme", "p_b_m:0.25", "--set", "31=100.5,53=-20", "--fdt", "joy:-0.5", "--fdt-hard"}));
}

TEST(FaceArguments, OfWhatNoOptionSaysAreTheWholeState) {
  FaceState edited, fitted, listed, moved;
  edited.edits = {mien::CurveEdit()};
  fitted.deformation.table = "region,a1\n1,2\n";
  listed.deformation.table = "joy:0.5,fear:0.5";
  moved.texture = "anna.png";
  moved.textureMesh = "mien_warp_mesh,1,4,4\nrow,column,x,y\n";
  for (const FaceState& state : {edited, fitted, listed, moved})
    EXPECT_EQ(mien::faceArguments(state), (Words{"--state", mien::writeFaceState(state)}));
}

TEST(FaceArguments, ShellsReadThemBack) {
  EXPECT_EQ(mien::shellText({"mien", "render", "--fap", "my talk.fap", "it's", "", "a\nb", "$x"}),
            "mien render --fap 'my talk.fap' 'it'\\''s' '' 'a\nb' '$x'");
}

}  // namespace
