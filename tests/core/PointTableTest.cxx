#include <gtest/gtest.h>

#include "MarkerTable.h"
#include "PointTable.h"

using namespace mien;

namespace {

void expectPointFault(const std::string& text, const std::string& start, const std::string& part) {
  PointTable table;
  table.hasRegions = true;
  const std::string fault = table.parse(text);
  EXPECT_EQ(fault.rfind(start, 0), 0u) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault;
  EXPECT_TRUE(table.hasRegions && table.points.empty()) << "a refused file must leave what was there";
}

PointTable pointsOf(const std::string& text) {
  PointTable table;
  EXPECT_EQ(table.parse(text), "");
  return table;
}

}  // namespace

TEST(PointTable, ReadsColumnsByNameAndWritesThemBack) {
  PointTable table;
  MarkerOptions image;
  image.yDown = image.mirrored = true;
  const std::string text = "marker,x,y,region\nL,100.5,200,\nnose,,,\nlip,130,260.25,12\n";
  ASSERT_EQ(table.parse("\xEF\xBB\xBFy,marker,region,x\r\n200,L,,100.5\r\n,nose,,\r\n260.25,lip,12,130\r\n", image),
            "");
  ASSERT_EQ(table.points.size(), 3u);
  EXPECT_EQ(table.points[0].position, Eigen::Vector3d(-100.5, -200.0, 0.0));
  EXPECT_FALSE(table.points[1].seen);
  EXPECT_EQ(table.points[2].region, 12);
  EXPECT_EQ(table.points[2].line, 4);
  EXPECT_EQ(table.write(image), text);
}

TEST(PointTable, NamesTheLineAtFault) {
  expectPointFault("", "1: ", "header");
  expectPointFault("marker,x\n", "1: ", "marker, x and y");
  expectPointFault("marker,x,y\n\n", "1: ", "no marker");
  expectPointFault("marker,x,y\na,1\n", "2: ", "2 cells under 3 columns");
  expectPointFault("marker,x,y\na,1,2\n,1,2\n", "3: ", "no name");
  expectPointFault("marker,x,y\na,1,nan\n", "2: a: 'nan' in column y", "finite");
  expectPointFault("marker,x,y\na,1,2\na,1,2\n", "3: ", "given twice");
  expectPointFault("marker,x,y,region\na,1,2,17\n", "2: a: '17'", "1 to 16");
}

TEST(PointTable, FindsPupilsByNameOrPlace) {
  const PointTable table = pointsOf("marker,x,y\npupil_left,3,1\npupil_right,-3,1\neye,,\n");
  MarkerOptions options;
  EyePupils pupils;
  ASSERT_EQ(table.findPupils(options, pupils), "");
  EXPECT_EQ(pupils.left, Eigen::Vector3d(3.0, 1.0, 0.0));
  options.leftPupil = "eye";
  EXPECT_EQ(table.findPupils(options, pupils).rfind("4: the pupil eye is missing", 0), 0u);
  options.yDown = true;
  options.neutralPupils = EyePupils{{5.0, 6.0, 0.0}, {-5.0, 6.0, 0.0}};
  ASSERT_EQ(table.findPupils(options, pupils), "");
  EXPECT_EQ(pupils.right, Eigen::Vector3d(-5.0, -6.0, 0.0));
}

TEST(PointTable, TwoStatesJoinByTheNamesOfTheirMarkers) {
  const PointTable before = pointsOf("marker,x,y\npupil_left,3,0\npupil_right,-3,0\nchin,0,-9\nnose,0,-4\nlip,,\n");
  const PointTable after = pointsOf("marker,x,y\nchin,0,-10\npupil_right,-3,0\nlip,0,-6\npupil_left,3,0\nbrow,1,2\n");
  MarkerTable joined, whole;
  ASSERT_EQ(joined.join(before, after), "");
  ASSERT_EQ(joined.markers.size(), 1u);
  EXPECT_EQ(joined.markers[0].name, "chin");
  EXPECT_EQ(joined.markers[0].expression, Eigen::Vector3d(0.0, -10.0, 0.0));
  EXPECT_EQ(joined.missing, (std::vector<std::string>{"nose", "lip", "brow"}));
  EXPECT_EQ(joined.neutral.unit(), 3.0);
  PointTable deep = after;
  deep.hasDepth = true;
  EXPECT_NE(joined.join(before, deep).find("column z"), std::string::npos);
  EXPECT_EQ(joined.markers.size(), 1u);
}

TEST(PointTable, AChinTellsWhichWayIsUp) {
  const auto at = [](const char* name, double height) { return std::pair(name, Eigen::Vector2d(0.0, height)); };
  EXPECT_EQ(describePosture({at("brow", 2.0), at("chin", -3.0)}, true), "");
  for (const char* chin : {"landmark08", "landmark8", "chin"})
    for (const bool whole : {false, true})
      EXPECT_NE(describePosture({at("brow", -2.0), at(chin, 3.0)}, whole).find("--y-down"), std::string::npos) << chin;
  MarkerPlaces many(15, at("m", 1.0));
  EXPECT_EQ(describePosture(many, true), "") << "brows alone may lie above the eyes";
  many.push_back(at("m", 1.0));
  EXPECT_NE(describePosture(many, true), "");
  EXPECT_EQ(describePosture(many, false), "") << "markers of the forehead alone";
}

TEST(PointTable, LandmarksTellWhichSideIsWhich) {
  // A picture (y downwards) whose pupils are named as the viewer sees them: turned round by its pupils, the chin hangs
  // where it should and left is right.
  std::string text = "marker,x,y\npupil_left,100,200\npupil_right,160,200\nlandmark08,130,310\n";
  text += "landmark36,90,200\nlandmark39,110,200\nlandmark42,150,200\nlandmark45,170,200\n";
  const PointTable picture = pointsOf(text);
  MarkerTable joined;
  const std::string fault = joined.join(picture, picture, {}, {"a.csv", "b.csv"});
  EXPECT_EQ(fault.rfind("a.csv:2: the landmarks of the subject's right side lie beside the left pupil", 0), 0u)
      << fault;
  MarkerOptions options;
  options.leftPupil = "pupil_right";
  options.rightPupil = "pupil_left";
  options.yDown = true;
  PointTable image;
  ASSERT_EQ(image.parse(text, options), "");
  EXPECT_EQ(joined.join(image, image, options), "");
  options.mirrored = true;  // and the pupils exchanged back: two errors that hide each other
  std::swap(options.leftPupil, options.rightPupil);
  ASSERT_EQ(image.parse(text, options), "");
  EXPECT_NE(joined.join(image, image, options).find("right side"), std::string::npos);
}

TEST(PointTable, FaultsOfTwoFilesNameTheFileAndTheLine) {
  const std::string good = "marker,x,y\npupil_left,3,0\npupil_right,-3,0\nchin,0,-9\n";
  const auto fault = [&](const std::string& before, const std::string& after, const MarkerOptions& options = {}) {
    MarkerTable joined;
    return joined.join(pointsOf(before), pointsOf(after), options, {"a.csv", "b.csv"});
  };
  EXPECT_EQ(fault(good, good), "");
  const std::string blind = "marker,x,y\nchin,0,-9\npupil_left,,\npupil_right,-3,0\n";
  EXPECT_EQ(fault(good, blind).rfind("b.csv:3: the pupil pupil_left is missing", 0), 0u) << fault(good, blind);
  EXPECT_EQ(fault(blind, good).rfind("a.csv:3: the pupil pupil_left is missing", 0), 0u) << fault(blind, good);
  const std::string none = "marker,x,y\nchin,0,-9\npupil_right,-3,0\n";
  EXPECT_EQ(fault(good, none).rfind("b.csv:1: the pupil pupil_left is missing", 0), 0u) << fault(good, none);
  const std::string same = "marker,x,y\nchin,0,-9\npupil_left,3,0\npupil_right,3,0\n";
  EXPECT_EQ(fault(good, same).rfind("b.csv:3: the pupils coincide", 0), 0u) << fault(good, same);
  MarkerOptions places;
  places.neutralPupils = EyePupils{{3.0, 0.0, 0.0}, {3.0, 0.0, 0.0}};
  EXPECT_EQ(fault(good, good, places).rfind("a.csv: the places given for the pupils", 0), 0u)
      << fault(good, good, places);
}
