#include <gtest/gtest.h>

#include <functional>

#include "FaceArguments.h"
#include "FaceFiles.h"
#include "FaceStateText.h"
#include "Program.h"
#include "TextFile.h"

namespace {

using mien::FaceState;
using Change = std::function<void(FaceState&)>;

/// The state that a picture carries which a shell drew at this command.
std::string drawnState(const TemporaryFolder& folder, const FaceState& state) {
  std::vector<std::string> words = {MIEN_PROGRAM, "render"};
  for (const std::string& word : mien::faceArguments(state)) words.push_back(word);
  for (const char* word : {"--size", "40x40", "-o"}) words.push_back(word);
  words.push_back(folder.file("face.png"));
  EXPECT_EQ(std::system(mien::shellText(words).c_str()), 0) << mien::shellText(words);
  const std::string bytes = readTextFile(folder.file("face.png"));
  const size_t begin = bytes.find("{", bytes.find("MienFaceState"));
  return bytes.substr(begin, bytes.find("\n}", begin) + 3 - begin);
}

/// One change for every property of the surface and of what moves it, and mixtures that options cannot say.
std::vector<Change> changes() {
  return {[](FaceState&) {},
          [](FaceState& s) {
            s.edits = {{6, 1.0 / 3.0, {0.1, 0.2, 1.0 / 7.0}, 0.7, 1, true}};
          },
          [](FaceState& s) { s.surface.scheme = "four-curve"; },
          [](FaceState& s) { s.surface.smoothing.fill(0.1 + 0.2); },
          [](FaceState& s) { s.surface.smoothing[4] = 1.0 / 3.0; },
          [](FaceState& s) { s.surface.modes = 7, s.surface.remainder = false; },
          [](FaceState& s) { s.surface.scheme = "derivative", s.surface.derivativeStrength = 1.0 / 3.0; },
          [](FaceState& s) { s.rows = 83, s.columns = 44, s.uniformRows = true, s.doublePrecision = true; },
          [](FaceState& s) {
            s.fapValues = {{31, 1000.0 / 3.0}, {53, -20.0}, {3, 1e5}};
          },
          [](FaceState& s) {
            s.expressions = {{"joy", 1.0 / 3.0}, {"fear", 1.0}};
          },
          [](FaceState& s) {
            s.visemes = {{"p b m", 0.2}, {"U", 1.0 / 3.0}};
          },
          [](FaceState& s) {
            s.deformation = {"smile", -1.0 / 3.0, false};
          },
          [](FaceState& s) {
            s.deformation = {"joy:0.5,fear:0.25", 0.5, true};
          }};
}

/// The same for what names files.
std::vector<Change> changesOfFiles(const TemporaryFolder& folder) {
  using Choice = FaceState::FrameChoice;
  const std::string demo = MIEN_DATA_DIR "/animation/demo.fap", painted = MIEN_DATA_DIR "/textures/painted.png";
  const std::string mesh = MIEN_DATA_DIR "/textures/painted_7x7.csv";
  const std::string face = folder.file("it's a face.vtp"), table = folder.file("my table.json");
  writeChangedFace([](auto&) {}, face);
  writeTextFile(table, readTextFile(MIEN_DATA_DIR "/animation/animation_table.json"));
  const auto atTime = [demo](FaceState& s) { s.fapFile = demo, s.frame = 1.0 / 3.0, s.frameChoice = Choice::Time; };
  return {[=](FaceState& s) { s.curvesFile = face; },
          [=](FaceState& s) { s.fapFile = demo, s.frame = 100; },
          [=](FaceState& s) { s.fapFile = demo, s.frame = 7, s.frameChoice = Choice::Number; },
          atTime,
          [=](FaceState& s) { atTime(s), s.interpolateFrames = true; },
          [=](FaceState& s) { s.fapFile = demo, s.frame = 3, s.interpolateFrames = true; },
          [=](FaceState& s) { s.animationTable = table; },
          [=](FaceState& s) { s.texture = painted; },
          [=](FaceState& s) { s.texture = painted, s.textureMesh = mesh; },
          [=](FaceState& s) { s.texture = painted, s.textureMesh = readTextFile(mesh); }};
}

TEST(CopiedCommand, OfEveryStateDrawsThatState) {
  const TemporaryFolder folder;
  std::vector<Change> all = changes();
  for (const Change& change : changesOfFiles(folder)) all.push_back(change);
  for (size_t i = 0; i < all.size(); ++i) {
    FaceState state;
    all[i](state);
    EXPECT_EQ(drawnState(folder, state), mien::writeFaceState(state)) << "change " << i;
  }
}

TEST(CopiedCommand, TheStateOfAFileIsChangedByOtherOptions) {
  const TemporaryFolder folder;
  FaceState state;
  state.expressions["joy"] = 0.5;
  state.rows = 29;
  const std::string file = folder.file("state.json");
  writeTextFile(file, mien::writeFaceState(state));
  const auto surfaceOf = [&](std::vector<std::string> options) {
    options.insert(options.begin(), "surface");
    options.insert(options.end(), {"-o", folder.file("points.csv")});
    const Outcome outcome = runMien(options);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
    return readTextFile(folder.file("points.csv"));
  };
  const std::string joy = surfaceOf({"--expression", "joy:0.5", "--resolution", "29x40"});
  EXPECT_EQ(surfaceOf({"--state", file}), joy);
  writeTextFile(file, "{\"format\": \"mien session\", \"version\": 1, \"face\": " + mien::writeFaceState(state) + "}");
  EXPECT_EQ(surfaceOf({"--state", file}), joy);
  EXPECT_EQ(surfaceOf({"--state", file, "--scheme", "spline"}),
            surfaceOf({"--expression", "joy:0.5", "--resolution", "29x40", "--scheme", "spline"}));
}

TEST(CopiedCommand, AStateThatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto expectRefused = [&](const std::string& state, int exitCode, const std::string& part) {
    const Outcome outcome = runMien({"surface", "--state", state, "-o", folder.file("x.vtp")});
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.errors;
    EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  };
  expectRefused("{\"mien_face_state\": 2, \"nose\": 1}", 2, "nose");
  expectRefused("{", 2, "ends at line 1 (cut off?)");
  expectRefused(folder.file("no.json"), 1, "no.json: ");
  writeTextFile(folder.file("a.json"), "{\"mien_face_state\": 7}");
  expectRefused(folder.file("a.json"), 1, "a.json: face state: 'mien_face_state' is 7");
}

}  // namespace
