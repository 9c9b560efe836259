#include <gtest/gtest.h>

#include "MarkerTable.h"
#include "PointTable.h"

using namespace mien;

namespace {

void expectFault(const std::string& text, const std::string& start, const std::string& part) {
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
  expectFault("", "1: ", "header");
  expectFault("marker,x\n", "1: ", "marker, x and y");
  expectFault("marker,x,y\n\n", "1: ", "no marker");
  expectFault("marker,x,y\na,1\n", "2: ", "2 cells under 3 columns");
  expectFault("marker,x,y\na,1,2\n,1,2\n", "3: ", "no name");
  expectFault("marker,x,y\na,1,nan\n", "2: a: 'nan' in column y", "finite");
  expectFault("marker,x,y\na,1,2\na,1,2\n", "3: ", "given twice");
  expectFault("marker,x,y,region\na,1,2,17\n", "2: a: '17'", "1 to 16");
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
  EXPECT_EQ(describePosture({{"brow", 2.0}, {"chin", -3.0}}), "");
  EXPECT_NE(describePosture({{"brow", -2.0}, {"landmark08", 3.0}}).find("--y-down"), std::string::npos);
  std::vector<std::pair<std::string, double>> many(15, {"m", 1.0});
  EXPECT_EQ(describePosture(many), "") << "brows alone may lie above the eyes";
  many.emplace_back("m", 1.0);
  EXPECT_NE(describePosture(many), "");
}
