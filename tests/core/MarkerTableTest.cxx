#include <gtest/gtest.h>

#include "MarkerTable.h"

using namespace mien;

namespace {

const std::string markerHeader = "marker,neutral_x,neutral_y,expression_x,expression_y\n";
const std::string pupilRows = "pupil_left,30,40,31,41\npupil_right,-30,40,-29,41\n";

void expectMarkerFault(const std::string& text, const std::string& start, const std::string& part) {
  MarkerTable table;
  table.missing = {"kept"};
  const std::string fault = table.parse(text);
  EXPECT_EQ(fault.rfind(start, 0), 0u) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault;
  EXPECT_EQ(table.missing.size(), 1u) << "a refused file must leave what was there";
}

}  // namespace

TEST(MarkerTable, ReadsColumnsByName) {
  MarkerTable table;
  ASSERT_EQ(
      table.parse("region,expression_y,expression_x,marker,neutral_y,neutral_x\r\n,41,31,pupil_left,40,30\r\n,41,-29,"
                  "pupil_right,40,-30\r\n16,-70,1,chin,-60,0\r\n"),
      "");
  ASSERT_EQ(table.markers.size(), 1u);
  EXPECT_EQ(table.markers[0].region, 16);
  EXPECT_EQ(table.markers[0].line, 4);
  EXPECT_EQ(table.markers[0].expression, Eigen::Vector3d(1.0, -70.0, 0.0));
  EXPECT_FALSE(table.hasDepth);
  EXPECT_NEAR(table.neutral.unit(), 30.0, 1e-13);
}

TEST(MarkerTable, LinesWithANumberSignAreComments) {
  MarkerTable table;
  ASSERT_EQ(
      table.parse("\xEF\xBB\xBF# made by hand\n\n" + markerHeader + "# pupils\n" + pupilRows + "chin,0,-60,0,-61\n"),
      "");
  ASSERT_EQ(table.markers.size(), 1u);
  EXPECT_EQ(table.markers[0].line, 7);
  PointTable points;
  ASSERT_EQ(points.parse("# one state\nmarker,x,y\nchin,0,-60\n"), "");
  EXPECT_EQ(points.points[0].line, 3);
}

TEST(MarkerTable, BlankCellsAreMissingMarkers) {
  MarkerTable table;
  ASSERT_EQ(table.parse(markerHeader + pupilRows + "nose,0,5,,\nchin,0,-60,0,-61\n"), "");
  EXPECT_EQ(table.markers.size(), 1u);
  EXPECT_EQ(table.missing, std::vector<std::string>{"nose"});
}

TEST(MarkerTable, TakesImagesAndMirroredOnes) {
  MarkerTable table;
  MarkerOptions options;
  options.yDown = true;
  options.mirrored = true;
  options.leftPupil = "L";
  options.rightPupil = "R";
  ASSERT_EQ(table.parse(markerHeader + "L,100,200,100,200\nR,160,200,160,200\nchin,130,300,130,310\n", options), "");
  EXPECT_NEAR(table.neutral.apply(table.markers[0].neutral).y(), -100.0 / 30.0, 1e-12);
  options.yDown = false;
  EXPECT_NE(table.parse(markerHeader + "L,100,200,100,200\nR,160,200,160,200\nchin,130,300,130,310\n", options)
                .find("--y-down"),
            std::string::npos);
}

TEST(MarkerTable, NamesTheLineAtFault) {
  expectMarkerFault("", "1: ", "header");
  expectMarkerFault("marker,neutral_x\n", "1: ", "header");
  expectMarkerFault("marker,neutral_x,neutral_y,neutral_z,expression_x,expression_y\n", "1: ", "neither");
  expectMarkerFault(markerHeader + "pupil_left,30,40,31,41\nnose,0,0,0,0\n", "1: ", "pupil_right is missing");
  expectMarkerFault(markerHeader + "pupil_left,30,40,31,41\npupil_right,,,,\nnose,0,0,0,0\n",
                    "3: ", "pupil_right is missing");
  expectMarkerFault(markerHeader + "pupil_left,30,40,31,41\npupil_right,30,40,1,1\nnose,0,0,0,0\n", "2: ", "coincide");
  expectMarkerFault(markerHeader + pupilRows + "nose,0,nan,0,0\n", "4: ", "nose");
  expectMarkerFault(markerHeader + pupilRows + "nose,0,inf,0,0\n", "4: ", "finite");
  expectMarkerFault(markerHeader + pupilRows + "nose,0,0,0\n", "4: ", "4 cells under 5 columns");
  expectMarkerFault(markerHeader + pupilRows + "nose,0,0,0,0,7\n", "4: ", "6 cells");
  expectMarkerFault(markerHeader + pupilRows + "nose,0,0,0,0\nnose,0,0,0,0\n", "5: ", "twice");
  expectMarkerFault(markerHeader + pupilRows + ",0,0,0,0\n", "4: ", "no name");
  expectMarkerFault(markerHeader + pupilRows, "3: ", "no marker");
  expectMarkerFault(markerHeader + pupilRows + "chin,0,90,0,90\n", "2: ", "chin");
}
