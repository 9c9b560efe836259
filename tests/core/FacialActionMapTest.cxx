#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "CaptureParser.h"
#include "FAPTable.h"
#include "FacialActions.h"
#include "QuotedCells.h"
#include "ReferenceData.h"

using namespace mien;

namespace {

/// The one frame that a table of one column at full strength gives.
FAPFrame imported(const std::string& column, CaptureKind kind) {
  FAPSequence sequence;
  const auto error = parseCapture(column + "\n1\n", kind, bundledFacialActions(), sequence);
  EXPECT_FALSE(error.has_value()) << column << ": " << error->message;
  return sequence.frames.empty() ? FAPFrame() : sequence.frames[0];
}

int signOf(double value) {
  return (value > 0.0) - (value < 0.0);
}

/// Rows of the reference that the map leaves out, with a reason: "AU18 8".
std::set<std::string> leftOut() {
  const std::string text = readTextFile(MIEN_DATA_DIR "/animation/facs_map.json");
  std::istringstream lines(text.substr(text.find("\"left_out\"")));
  std::set<std::string> rows;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name = line.find("\"AU"), list = line.find('[', name);
    if (name == line.npos) continue;
    std::istringstream faps(line.substr(list + 1, line.find(']') - list - 1));
    for (std::string fap; std::getline(faps, fap, ',');)
      rows.insert(line.substr(name + 1, line.find('"', name + 1) - name - 1) + " " + std::to_string(std::stoi(fap)));
  }
  return rows;
}

/// The direction that the sources of a row agree on: its first library's, or that of all others; 0 for none.
int wantedSign(const std::vector<std::string>& cells) {
  if (!cells[7].empty()) return signOf(std::stod(cells[7]));
  int sign = 0;
  for (int library = 8; library < 13; ++library) {
    if (cells[library].empty()) continue;
    const int other = signOf(std::stod(cells[library]));
    if (sign != 0 && other != sign) return 0;
    sign = other;
  }
  return sign;
}

std::vector<std::vector<std::string>> referenceRows(const std::string& type) {
  std::istringstream lines(readTextFile(referencePath("mpeg4/facs_map.csv")));
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    const auto cells = quotedCells(line);
    if (cells[0] == type) rows.push_back(cells);
  }
  return rows;
}

}  // namespace

TEST(FacialActionMap, HoldsWhatARKitAndOpenFaceHave) {
  const FacialActionMap map = bundledFacialActions();
  EXPECT_EQ(map.blendshapes.size(), 52u);
  for (const int unit : {1, 2, 4, 5, 6, 7, 9, 10, 12, 14, 15, 17, 20, 23, 25, 26, 28, 45})
    EXPECT_NE(findAction(map.actionUnits, "AU" + std::to_string(unit)), nullptr) << unit;
  for (const char* rotation : {"HeadYaw", "HeadPitch", "HeadRoll", "pose_Rx", "pose_Ry", "pose_Rz"})
    EXPECT_NE(findAction(map.rotations, rotation), nullptr) << rotation;
}

TEST(FacialActionMap, NamesMayBeSpelledInManyWays) {
  const FacialActionMap map = bundledFacialActions();
  const CaptureAction* blink = findAction(map.blendshapes, "eyeBlinkLeft");
  ASSERT_NE(blink, nullptr);
  for (const char* name : {"EyeBlinkLeft", "eyeBlink_L", "eye_blink_left", "EYEBLINKLEFT", "eyeBlink-l"})
    EXPECT_EQ(findAction(map.blendshapes, name), blink) << name;
  EXPECT_EQ(findAction(map.blendshapes, "eyeBlink"), nullptr);
}

TEST(FacialActionMap, TheSidesMirrorEachOtherAndTogetherAreTheWhole) {
  const FacialActionMap map = bundledFacialActions();
  for (const CaptureAction& action : map.actionUnits) {
    std::map<int, double> sum;
    for (const bool left : {true, false})
      for (const auto& [fap, value] : sideOf(action, left).faps) sum[fap] += value;
    EXPECT_EQ(sum, (std::map<int, double>(action.faps.begin(), action.faps.end()))) << action.name;
  }
  for (const CaptureAction& shape : map.blendshapes) {
    const std::size_t left = shape.name.rfind("Left");
    if (left == std::string::npos) continue;
    const CaptureAction* right = findAction(map.blendshapes, shape.name.substr(0, left) + "Right");
    ASSERT_NE(right, nullptr) << shape.name;
    std::map<int, double> mirror;
    for (const auto& [fap, value] : shape.faps)
      mirror[fapDefinition(fap).mirrorPartner] = fapDefinition(fap).mirrorSign * value;
    EXPECT_EQ(mirror, (std::map<int, double>(right->faps.begin(), right->faps.end()))) << shape.name;
  }
}

TEST(FacialActionMap, BlendshapesMoveEveryFAPOfTheReferenceInItsDirection) {
  MIEN_REQUIRE_REFERENCE("mpeg4/facs_map.csv");
  const auto rows = referenceRows("ARKit_to_FAP_sign");
  EXPECT_EQ(rows.size(), 127u);
  for (const auto& cells : rows) {
    const FAPFrame frame = imported(cells[2], CaptureKind::Blendshapes);
    EXPECT_EQ(signOf(frame.value(std::stoi(cells[4]))), cells[13] == "+" ? 1 : -1) << cells[2] << " FAP " << cells[4];
  }
}

/// Of 422 rows 347 are checked; the others contradict each other or move the lips of a nodding head, and the map lists
/// them.
TEST(FacialActionMap, ActionUnitsMoveEveryFAPOfTheReferenceInItsDirection) {
  MIEN_REQUIRE_REFERENCE("mpeg4/facs_map.csv");
  const std::set<std::string> missing = leftOut();
  const auto rows = referenceRows("AU_to_FAP_value");
  EXPECT_EQ(rows.size(), 422u);
  std::size_t checked = 0;
  for (const auto& cells : rows) {
    const int wanted = wantedSign(cells);
    if (missing.count(cells[2] + " " + cells[4]) || wanted == 0) continue;
    if (cells[13 + 1].find("likely a slip") != std::string::npos) continue;  // AU15, FAP 54
    const FAPFrame frame = imported(cells[2], CaptureKind::ActionUnits);
    EXPECT_EQ(signOf(frame.value(std::stoi(cells[4]))), wanted) << cells[2] << " FAP " << cells[4];
    ++checked;
  }
  EXPECT_GE(checked, 340u);
}

/// Rows derived from the Candide-3 model: they decide nothing where libraries say otherwise, and these are all places
/// where the libraries do.
TEST(FacialActionMap, DerivedRowsGiveTheDirectionButWhereLibrariesContradictThem) {
  MIEN_REQUIRE_REFERENCE("mpeg4/facs_map.csv");
  const std::map<std::string, std::vector<std::string>> units = {
      {"AU13/15", {"AU15"}}, {"AU23/24", {"AU23", "AU24"}}, {"AU26/27", {"AU27"}}, {"AU42-45", {"AU43"}}};
  const std::set<std::pair<std::string, int>> contradicted = {{"AU15", 8},  {"AU15", 9},  {"AU15", 10}, {"AU15", 11},
                                                              {"AU15", 57}, {"AU15", 58}, {"AU27", 16}, {"AU27", 18}};
  const auto rows = referenceRows("AU_to_FAP_derived");
  EXPECT_EQ(rows.size(), 102u);
  for (const auto& cells : rows) {
    const auto known = units.find(cells[2]);
    for (const std::string& unit : known == units.end() ? std::vector<std::string>{cells[2]} : known->second) {
      const int fap = std::stoi(cells[4]);
      // The model pushes the jaw to the left, AU30 to the right.
      const int turned = unit == "AU30" ? -1 : contradicted.count({unit, fap}) ? -1 : 1;
      EXPECT_EQ(signOf(imported(unit, CaptureKind::ActionUnits).value(fap)), turned * signOf(std::stod(cells[13])))
          << unit << " FAP " << fap;
    }
  }
}

TEST(FacialActionMap, JawAndLipsGoToOneSide) {
  // FAP 15 is positive to the right, FAPs 6 and 53 outward on the left, 7 and 54 outward on the right.
  for (const auto& [name, kind, side] : {std::tuple{"AU30", CaptureKind::ActionUnits, 1},
                                         {"jawRight", CaptureKind::Blendshapes, 1},
                                         {"jawLeft", CaptureKind::Blendshapes, -1},
                                         {"mouthRight", CaptureKind::Blendshapes, 1},
                                         {"mouthLeft", CaptureKind::Blendshapes, -1}}) {
    const FAPFrame frame = imported(name, kind);
    int moved = 0;
    for (const auto& [fap, sign] : {std::pair{15, 1}, {6, -1}, {7, 1}, {53, -1}, {54, 1}, {39, -1}, {40, 1}}) {
      EXPECT_NE(signOf(frame.value(fap)), -sign * side) << name << " FAP " << fap;
      moved += frame.value(fap) != 0.0;
    }
    EXPECT_GT(moved, 0) << name;
  }
  EXPECT_EQ(imported("AU30", CaptureKind::ActionUnits).value(53), -62.0);
}

TEST(FacialActionMap, AnOpenedLipGoesFurthestInItsMiddle) {
  for (const auto& [name, kind] :
       {std::pair{"AU27", CaptureKind::ActionUnits}, {"jawOpen", CaptureKind::Blendshapes}}) {
    const FAPFrame frame = imported(name, kind);
    for (const auto& [side, middle] : {std::pair{10, 5}, {11, 5}, {57, 52}, {58, 52}}) {
      EXPECT_LT(frame.value(side), 0.0) << name << " FAP " << side;
      EXPECT_GE(frame.value(side), frame.value(middle)) << name << " FAP " << side;
    }
  }
}

TEST(FacialActionMap, FaultsAreToldAndLeaveTheMap) {
  FacialActionMap map = bundledFacialActions();
  const std::string head = "{\"format\": \"mien facial action map\", \"version\": 1, \"action_units\": [";
  const std::string tail = "], \"blendshapes\": [], \"rotations\": []}";
  EXPECT_NE(map.parse("{}").find("format"), std::string::npos);
  EXPECT_NE(map.parse("{\"format\": \"mien facial action map\", \"version\": 2}").find("version"), std::string::npos);
  EXPECT_NE(map.parse(head + "{\"name\": \"AU1\", \"faps\": {\"2\": 1}}" + tail).find("AU1"), std::string::npos);
  EXPECT_NE(map.parse(head + "{\"name\": \"AU1\", \"faps\": {\"3\": 1e9}}" + tail).find("FAP 3"), std::string::npos);
  const std::string twice = "{\"name\": \"AU1\", \"faps\": {}}, {\"name\": \"AU1\", \"faps\": {}}";
  EXPECT_NE(map.parse(head + twice + tail).find("twice"), std::string::npos);
  EXPECT_NE(map.parse(head + "{\"name\": \"AU1\", \"fap\": {}}" + tail).find("AU1: the key \"fap\" is unknown"),
            std::string::npos);
  EXPECT_EQ(map.faultLine, 0);
  const std::string broken = map.parse("{\"format\":\n\"mien facial action map\",,");
  EXPECT_EQ(broken.find("exception"), std::string::npos) << broken;
  EXPECT_NE(broken.find("no valid JSON"), std::string::npos) << broken;
  EXPECT_EQ(map.faultLine, 2);
  EXPECT_EQ(map.blendshapes.size(), 52u);
}
