#include <gtest/gtest.h>

#include <limits>

#include "FaceFiles.h"
#include "Program.h"
#include "TextFile.h"

namespace {

/// Runs `surface` with these options; whatever goes wrong must leave nothing behind.
void expectRefused(const std::vector<std::string>& options, int exitCode, const std::string& part) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments = {"surface", "-o", folder.file("x.vtp")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, exitCode) << part << ": " << outcome.errors;
  EXPECT_EQ(outcome.errors.rfind("mien: ", 0), 0u) << outcome.errors;
  EXPECT_NE(outcome.errors.find(part), std::string::npos) << outcome.errors;
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  EXPECT_EQ(entriesIn(folder.file("")), 0) << part;
}

TEST(FaceOptions, WrongValuesEndWithTwoAndSayWhatIsAllowed) {
  expectRefused({"--scheme", "soap"}, 2, "four-curve, derivative");
  expectRefused({"-a", "0"}, 2, "0 < a <= 1000");
  expectRefused({"-a", "-1"}, 2, "0 < a <= 1000");
  expectRefused({"-a", "nan"}, 2, "no number");
  expectRefused({"-a", "1,2,3"}, 2, "one for each of the 9");
  expectRefused({"-N", "21"}, 2, "0 .. 20");
  expectRefused({"-N", "5.5"}, 2, "no whole number");
  expectRefused({"--scheme", "four-curve", "-a", "50"}, 2, "250");
  expectRefused({"--resolution", "10x40"}, 2, "at least 11x3");
  expectRefused({"--resolution", "40"}, 2, "such as 56x40");
  expectRefused({"--resolution", "2000000000x2000000000"}, 2, "too fine");
  expectRefused({"--precision", "half"}, 2, "single or double");
  expectRefused({"--derivative-strength", "inf"}, 2, "no number");
  expectRefused({"--expression", "smug"}, 2, "joy, sadness");
  expectRefused({"--expression", "joy:2"}, 2, "0 .. 1");
  expectRefused({"--expression", "joy,joy:0.5"}, 2, "twice");
  expectRefused({"--expression", ""}, 2, "empty");
  expectRefused({"--expression", "joy,,fear"}, 2, "without a name");
  expectRefused({"--viseme", ""}, 2, "empty");
  expectRefused({"--viseme", "zz"}, 2, "1 p_b_m, 2 f_v");
  expectRefused({"--viseme", "15"}, 2, "14 U");
  expectRefused({"--viseme", "A:1.5"}, 2, "0 .. 1");
  expectRefused({"--viseme", "A,a:0.5"}, 2, "twice");
  expectRefused({"--viseme", "A,U,I"}, 2, "two visemes");
  expectRefused({"--set", ""}, 2, "empty");
  expectRefused({"--set", "open_yaw=5"}, 2, "open_jaw");
  expectRefused({"--set", "viseme_select1=5"}, 2, "--viseme");
  expectRefused({"--set", "open_jaw=5,3=6"}, 2, "twice");
  expectRefused({"--set", "53"}, 2, "53=200");
  expectRefused({"--fdt", "joy:3"}, 2, "-2 .. 2");
  expectRefused({"--fdt", "joy:x"}, 2, "--fdt");
  expectRefused({"--fdt", "smug"}, 1, "anger, disgust");
  expectRefused({"--fdt", "no/such.csv"}, 1, "no/such.csv: it cannot be opened");
  expectRefused({"--set", "99=1"}, 2, "3 .. 68");
  expectRefused({"--set", "53=1,53=2"}, 2, "twice");
  expectRefused({"--frame", "3"}, 2, "--fap");
}

/// The points of the surface under these options, as text.
std::string surfaceOf(const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  const std::string file = folder.file("points.csv");
  std::vector<std::string> arguments = {"surface", "--resolution", "20x12", "-o", file};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return readTextFile(file);
}

TEST(FaceOptions, NamesNumbersAndBlanksAreAllTheSame) {
  const std::string neutral = surfaceOf({}), jaw = surfaceOf({"--set", "3=200"});
  EXPECT_NE(neutral, jaw);
  for (const char* const set : {"open_jaw=200", "FAP3=200", " Open_Jaw = 200 ", "fap3_open_jaw=200"})
    EXPECT_EQ(surfaceOf({"--set", set}), jaw) << set;
  EXPECT_EQ(surfaceOf({"--expression", " joy: 0.5 , fear:0.25"}), surfaceOf({"--expression", "joy:0.5,fear:0.25"}));
  const std::string lips = surfaceOf({"--viseme", "p_b_m"});
  EXPECT_NE(lips, neutral);
  EXPECT_EQ(surfaceOf({"--viseme", "1"}), lips);
  EXPECT_EQ(surfaceOf({"--viseme", "P B M: 1"}), lips);
}

TEST(FaceOptions, TwoVisemesShareTheFaceAsInFAPOne) {
  const std::string blended = surfaceOf({"--viseme", "A:0.75,U:0.25"});
  EXPECT_EQ(surfaceOf({"--viseme", "A:0.75,14"}), blended);
  EXPECT_EQ(surfaceOf({"--viseme", "A,U"}), surfaceOf({"--viseme", "A:0.5,U:0.5"}));
  EXPECT_NE(surfaceOf({"--viseme", "A"}), blended);
}

TEST(FaceOptions, WrongFilesEndWithOneAndAreNamed) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.vtp");
  expectRefused({"--face", "no_such.vtp"}, 1, "no_such.vtp: ");
  writeTextFile(file, "hello");
  expectRefused({"--face", file}, 1, "face.vtp: ");
  writeChangedFace([](auto& face) { face.curves.curve(7)(3, 1) = std::numeric_limits<double>::quiet_NaN(); }, file);
  expectRefused({"--face", file}, 1, "face.vtp: ");
  writeChangedFace([](auto& face) { face.curves.curve(7).col(1).array() += 30.0; }, file);
  expectRefused({"--face", file}, 1, "C8");
  expectRefused({"--fat", folder.file("no.json"), "--set", "53=1"}, 1, "no.json");
}

TEST(FaceOptions, AFigureOrPictureGivesTheFaceThatItShows) {
  const TemporaryFolder folder;
  const auto run = [](const std::vector<std::string>& words) {
    const Outcome outcome = runMien(words);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  };
  const std::string table = folder.file("table.csv"), other = folder.file("other.csv"),
                    again = folder.file("again.csv");
  const std::vector<std::string> face = {"spectrum", "-a", "2", "-N", "7", "--expression", "joy", "-o"};
  for (const std::string& output : {table, folder.file("f.svg"), folder.file("f.pdf"), folder.file("f.png")}) {
    std::vector<std::string> words = face;
    words.push_back(output);
    run(words);
  }
  run({"spectrum", "-o", other});
  EXPECT_NE(readTextFile(table), readTextFile(other));
  run({"render", "-a", "2", "-N", "7", "--expression", "joy", "--size", "100x100", "-o", folder.file("r.png")});
  for (const std::string figure : {"f.svg", "f.pdf", "f.png", "r.png"}) {
    run({"spectrum", "--state", folder.file(figure), "--resolution", "56x40", "-o", again});
    EXPECT_EQ(readTextFile(table), readTextFile(again)) << figure;
  }
}

TEST(FaceOptions, FiguresWithoutAStateAreRefused) {
  const TemporaryFolder folder;
  const std::string figure = folder.file("f.svg");
  expectRefused({"--state", figure}, 1, "f.svg: cannot be read");
  writeTextFile(figure, "<svg><desc>mien figure --list</desc></svg>");
  expectRefused({"--state", figure}, 1, "f.svg: the figure carries no state of a face");
  writeTextFile(figure, "<svg><desc>mien figure\n{\"mien_face_state\": 2,</desc></svg>");
  expectRefused({"--state", figure}, 1, "f.svg: ");
  expectRefused({"--state", MIEN_DATA_DIR "/textures/painted.png"}, 1, "painted.png: ");
}

TEST(FaceOptions, FramesThatAreNotThereAreRefused) {
  const TemporaryFolder folder;
  const std::string demo = std::string(MIEN_DATA_DIR) + "/animation/demo.fap";
  expectRefused({"--fap", demo, "--frame", "99999"}, 2, "numbers run from 0 to 300");
  expectRefused({"--fap", demo, "--index", "301"}, 2, "from 0 to 300");
  expectRefused({"--fap", demo, "--index", "-1"}, 2, "index");
  expectRefused({"--fap", demo, "--time", "-1"}, 2, "before the first");
  expectRefused({"--fap", demo, "--frame", "1", "--index", "1"}, 2, "--index");
  expectRefused({"--fap", folder.file("no.fap")}, 1, "no.fap");
}

TEST(FaceOptions, AFaceWithoutFeaturePointsIsShownButNotAnimated) {
  const TemporaryFolder folder;
  const std::string face = folder.file("bare.vtp"), output = folder.file("x.vtp");
  writeChangedFace([](auto& changed) { changed.features.clear(); }, face);
  EXPECT_EQ(runMien({"surface", "--face", face, "-o", output}).exitCode, 0);
  EXPECT_EQ(runMien({"surface", "--face", face, "--expression", "joy", "-o", output}).exitCode, 1);
}

}  // namespace
