#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "FAPUnits.h"
#include "FaceFiles.h"
#include "Program.h"

namespace {

using nlohmann::json;

json infoOf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "info");
  arguments.push_back("--json");
  const Outcome outcome = runMien(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.errors;
  return json::parse(outcome.output, nullptr, false);
}

const char* const smallFAP =
    "# eyes and mouth\n2.1 small 10 3\n"
    "0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 "
    "0 0 0 0 0 0 0 0 0 0 0\n"
    "7 10 0 0 0\n"
    "0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 1 0 0 1 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 "
    "0 0 0 0 0 0 0 0 0 0 0\n"
    "8 20 512 512 5\n";

TEST(InfoCommand, TellsTheGenericFace) {
  const json face = infoOf({})["face"];
  EXPECT_EQ(face["curves"], 29);
  EXPECT_EQ(face["patches"], 9);
  EXPECT_EQ(face["points_per_curve"], 40);
  EXPECT_EQ(face["bytes"], 29 * 40 * 3 * 4);
  EXPECT_EQ(face["units"], "mm");
  EXPECT_TRUE(face["curves_missed"].empty());
  mien::FAPUnits units;
  ASSERT_EQ(mien::measureFAPUnits(genericFace(), units), "");
  EXPECT_EQ(face["fapu"]["ES"], units.eyeSeparation);
  EXPECT_EQ(face["fapu"]["ENS"], units.eyeNoseSeparation);
  EXPECT_EQ(face["fapu"]["MNS"], units.mouthNoseSeparation);
  EXPECT_EQ(face["fapu"]["MW"], units.mouthWidth);
  EXPECT_EQ(face["fapu"]["IRISD"], units.irisDiameter);
}

TEST(InfoCommand, TellsTheCurvesThatTheResolutionMisses) {
  EXPECT_TRUE(infoOf({"--resolution", "83x40"})["face"]["curves_missed"].empty());
  EXPECT_EQ(infoOf({"--resolution", "11x40"})["face"]["curves_missed"].size(), 18u);
}

TEST(InfoCommand, TellsAFaceFile) {
  const TemporaryFolder folder;
  const std::string file = folder.file("face.vtp");
  writeFaceFile(genericFace(), file);
  EXPECT_EQ(infoOf({file})["face"]["name"], file);
  EXPECT_EQ(infoOf({"--face", file})["face"]["points_per_curve"], 40);
}

TEST(InfoCommand, AFaceWithoutFeaturePointsHasNoUnits) {
  const TemporaryFolder folder;
  writeChangedFace([](mien::FaceCurves& face) { face.features.clear(); }, folder.file("bare.vtp"));
  const Outcome outcome = runMien({"info", folder.file("bare.vtp"), "--json"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_TRUE(json::parse(outcome.output)["face"]["fapu"].is_null());
  EXPECT_NE(outcome.errors.find("bare.vtp: "), std::string::npos) << outcome.errors;
}

TEST(InfoCommand, TellsAnAnimation) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("small.fap"), smallFAP);
  const json fap = infoOf({folder.file("small.fap")})["fap"];
  EXPECT_EQ(fap["version"], "2.1");
  EXPECT_EQ(fap["name"], "small");
  EXPECT_EQ(fap["fps"], 10.0);
  EXPECT_EQ(fap["frames"], 2);
  EXPECT_EQ(fap["faps_used"], json({3, 19, 20, 23}));
  EXPECT_EQ(fap["faps_without_surface"], json({23}));
  EXPECT_EQ(fap["duration"], 0.1);
  ASSERT_EQ(fap["warnings"].size(), 1u);  // the header speaks of three frames
  EXPECT_NE(fap["warnings"][0].get<std::string>().find("small.fap:2: "), std::string::npos) << fap["warnings"];
}

TEST(InfoCommand, OnlyFAPsWithValuesAreWithoutSurface) {
  const TemporaryFolder folder;
  std::string mask;
  for (int fap = 1; fap <= 68; ++fap) mask += fap == 23 || fap == 53 ? "1 " : "0 ";
  writeTextFile(folder.file("still.fap"), "2.1 still 25 1\n" + mask + "\n0 0 100\n");
  const json fap = infoOf({folder.file("still.fap")})["fap"];
  EXPECT_EQ(fap["faps_used"], json({23, 53}));
  EXPECT_EQ(fap["faps_without_surface"], json::array());
}

TEST(InfoCommand, TellsHowOftenLipsArePressedTogether) {
  const TemporaryFolder folder;
  std::string mask;
  for (int fap = 1; fap <= 68; ++fap) mask += fap == 51 || fap == 52 ? "1 " : "0 ";
  writeTextFile(folder.file("lips.fap"),
                "2.1 lips 25 3\n" + mask + "\n0 0 0\n" + mask + "\n1 200 200\n" + mask + "\n2 -200 -200\n");
  const json contact = infoOf({folder.file("lips.fap")})["fap"]["contact"];
  EXPECT_EQ(contact["frames"], 1);
  EXPECT_GT(contact["largest_mm"], 1.0);
  EXPECT_LT(contact["largest_mm"], 20.0);
}

TEST(InfoCommand, TextSaysTheSame) {
  const Outcome outcome = runMien({"info"});
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char* part : {"29", "40 points", "13920 bytes", "IRISD"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
}

TEST(InfoCommand, MalformedAnimationIsRefusedWithFileAndLine) {
  const TemporaryFolder folder;
  writeTextFile(folder.file("bad.fap"), "2.1 bad 25 1\n0 1 2\n0 5\n");
  const Outcome outcome = runMien({"info", folder.file("bad.fap")});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.errors.rfind("mien: " + folder.file("bad.fap") + ":2: ", 0), 0u) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
}

/// The files are called lineN_what.fap, N being the line that must be named.
TEST(InfoCommand, EveryMalformedAnimationIsRefusedWithFileAndLineByEveryCommandThatReadsIt) {
  const TemporaryFolder folder;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/fap")) {
    const std::string file = entry.path().string(), name = entry.path().filename().string();
    const std::string place = "mien: " + file + ":" + std::to_string(std::stoi(name.substr(4))) + ": ";
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"info", file},
          {"curves", "--fap", file, "--index", "0", "-o", folder.file("curves.csv")}}) {
      const Outcome outcome = runMien(words);
      EXPECT_EQ(outcome.exitCode, 1) << name;
      EXPECT_EQ(outcome.errors.rfind(place, 0), 0u) << outcome.errors;
      EXPECT_EQ(outcome.output, "") << name;
    }
    ++files;
  }
  EXPECT_GE(files, 37);
  EXPECT_EQ(entriesIn(folder.file("")), 0) << "a refused animation must leave no file";
}

TEST(InfoCommand, TellsAScan) {
  const TemporaryFolder folder;
  const std::string scan = folder.file("face.ply");
  ASSERT_EQ(runMien({"surface", "-o", scan}).exitCode, 0);
  const json about = infoOf({scan})["scan"];
  EXPECT_EQ(about["unit"], "mm");
  EXPECT_EQ(about["components"], 1);
  EXPECT_GT(about["points"], 1000);
  EXPECT_GE(about["boundary_loops"], 2) << "above and below";
  EXPECT_EQ(about["polygons"]["triangles"].get<int>() + 2 * about["polygons"]["quads"].get<int>(), about["triangles"]);
  EXPECT_EQ(about["bounds"], about["bounds_mm"]);
  const json face = infoOf({})["face"];
  EXPECT_NEAR(about["bounds"]["z"][1].get<double>(), face["bounds"]["z"][1].get<double>(), 3.0);
  const Outcome outcome = runMien({"info", scan});
  for (const char* const part : {"components", "boundary loops", "unit", "mm, guessed"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << outcome.output;
}

TEST(InfoCommand, TellsWhichKindOfFileAJsonIs) {
  const std::string data = MIEN_DATA_DIR;
  const json table = infoOf({data + "/animation/animation_table.json"})["json"];
  EXPECT_EQ(table["kind"], "animation table");
  EXPECT_EQ(table["version"], 3);
  EXPECT_EQ(infoOf({data + "/deformation/regions.json"})["json"]["kind"], "map of facial regions");
  const TemporaryFolder folder;
  writeTextFile(folder.file("study.json"), R"({"mien_study": 1})");
  EXPECT_EQ(infoOf({folder.file("study.json")})["json"]["kind"], "study");
  for (const char* const text : {"{", "[]", R"({"format": "other", "regions": 1})"}) {
    writeTextFile(folder.file("other.json"), text);
    const Outcome outcome = runMien({"info", folder.file("other.json")});
    EXPECT_EQ(outcome.exitCode, 1) << text;
    EXPECT_EQ(outcome.errors.rfind("mien: " + folder.file("other.json") + ": this ", 0), 0u) << outcome.errors;
  }
}

TEST(InfoCommand, TellsPhotographsTheirMeshesAndLandmarks) {
  const std::string textures = MIEN_DATA_DIR "/textures/";
  const json photograph = infoOf({textures + "painted.png"})["picture"];
  EXPECT_EQ(photograph["kind"], "photograph");
  EXPECT_EQ(photograph["mesh"], textures + "painted.csv");
  EXPECT_GT(photograph["pixels"][0], 100);
  EXPECT_GT(photograph["mesh_rows"], 7);
  const json mesh = infoOf({textures + "painted_7x7.csv"})["picture"];
  EXPECT_EQ(mesh["mesh_rows"], 7);
  EXPECT_EQ(mesh["mesh_columns"], 7);
  const json landmarks = infoOf({MIEN_DATA_DIR "/faces/generic68.csv"})["picture"];
  EXPECT_EQ(landmarks["landmarks"], 68);
  EXPECT_EQ(landmarks["kind"], "landmarks of a scan");
  EXPECT_NE(runMien({"info", textures + "painted.png"}).output.find("mesh beside it"), std::string::npos);
}

/// Every command that reads scans says the same of a bad one, and leaves nothing behind.
TEST(InfoCommand, EveryMalformedScanIsRefusedByEveryCommandThatReadsIt) {
  const TemporaryFolder folder;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MIEN_TEST_DIR "/data/malformed/scans")) {
    const std::string file = entry.path().string();
    for (const std::vector<std::string>& words : {std::vector<std::string>{"info", file},
                                                  {"acquire", file, "-o", folder.file("face.vtp")},
                                                  {"compare", file, file, "-o", folder.file("distance.vtp")}}) {
      const Outcome outcome = runMien(words);
      EXPECT_EQ(outcome.exitCode, 1) << words[0] << " " << file;
      EXPECT_EQ(outcome.errors.rfind("mien: " + file + ":", 0), 0u) << outcome.errors;
      EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
      EXPECT_EQ(outcome.output, "") << file;
    }
    ++files;
  }
  EXPECT_EQ(files, 86);
  EXPECT_EQ(entriesIn(folder.file("")), 0);
}

TEST(InfoCommand, AFigureTellsItsTitleAndCommand) {
  const TemporaryFolder folder;
  for (const std::string ending : {"svg", "pdf", "png"}) {
    const std::string figure = folder.file("f." + ending);
    ASSERT_EQ(runMien({"spectrum", "-a", "2", "-o", figure}).exitCode, 0);
    const Outcome told = runMien({"info", figure, "--json"});
    ASSERT_EQ(told.exitCode, 0) << told.errors;
    const auto about = nlohmann::json::parse(told.output)["figure"];
    EXPECT_EQ(about["command"], "mien spectrum --smoothing 2");
    EXPECT_EQ(about["state"]["surface"]["a"][0], 2.0);
    EXPECT_NE(runMien({"info", figure}).output.find("mien spectrum --smoothing 2"), std::string::npos);
  }
  writeTextFile(folder.file("g.svg"), "<svg/>");
  const Outcome other = runMien({"info", folder.file("g.svg")});
  EXPECT_EQ(other.exitCode, 1);
  EXPECT_NE(other.errors.find("g.svg: holds no description"), std::string::npos) << other.errors;
}

}  // namespace
