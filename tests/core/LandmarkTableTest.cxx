#include <gtest/gtest.h>

#include <sstream>

#include "LandmarkTable.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

/// A right file; line `changed` (the header is line 1) is replaced by `text`.
std::string landmarkFile(const std::string& header, bool vertices, int changed = 0, const std::string& text = {}) {
  std::ostringstream file;
  file << (changed == 1 ? text : header) << "\n";
  for (int i = 0; i < 68; ++i) {
    if (changed == i + 2)
      file << text << "\n";
    else if (vertices)
      file << i << "," << 2 * i << "\r\n";
    else
      file << i << "," << i << ".5,2,-3e1\n";
  }
  return file.str();
}

void expectLandmarkFault(const std::string& file, const std::string& start, const std::string& part) {
  LandmarkTable table;
  table.hasVertices = true;
  table.vertices[3] = 77;
  const std::string fault = parseLandmarks(file, table);
  EXPECT_EQ(fault.rfind(start, 0), 0u) << fault;
  EXPECT_NE(fault.find(part), std::string::npos) << fault;
  EXPECT_EQ(table.vertices[3], 77) << "a refused file must leave what was there";
}

}  // namespace

TEST(LandmarkTable, ReadsPositions) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,x,y,z", false), table), "");
  EXPECT_FALSE(table.hasVertices);
  EXPECT_EQ(table.positions[67], Eigen::Vector3d(67.5, 2.0, -30.0));
}

TEST(LandmarkTable, ReadsVerticesAndTakesPositionsFromTheMesh) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,vertex", true), table), "");
  const TriangleMesh mesh = ellipticHead().mesh();
  FaceLandmarks landmarks;
  ASSERT_EQ(placeLandmarks(table, mesh, landmarks), "");
  EXPECT_EQ(landmarks[10], Eigen::Vector3d(mesh.vertices.row(20)));
}

TEST(LandmarkTable, ReadsColumnsInAnyOrder) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,z,x,y", false), table), "");
  EXPECT_EQ(table.positions[1], Eigen::Vector3d(2.0, -30.0, 1.5));
}

TEST(LandmarkTable, AByteOrderMarkIsNoPartOfTheFirstColumn) {
  LandmarkTable plain, marked;
  const std::string file = landmarkFile("landmark,x,y,z", false, 4, "3,0,0,0");  // not in the order of the numbers
  const std::string sound = landmarkFile("landmark,x,y,z", false);
  ASSERT_EQ(parseLandmarks(sound, plain), "");
  ASSERT_EQ(parseLandmarks("\xEF\xBB\xBF" + sound, marked), "");
  EXPECT_EQ(marked.positions.points, plain.positions.points);
  expectLandmarkFault("\xEF\xBB\xBF" + file, "5: ", "landmark 3 is given twice");
}

TEST(LandmarkTable, RefusesAVertexTheMeshDoesNotHave) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,vertex", true, 5, "3,99999999"), table), "");
  FaceLandmarks landmarks;
  EXPECT_NE(placeLandmarks(table, ellipticHead().mesh(), landmarks).find("landmark 3 is vertex 99999999"),
            std::string::npos);
}

TEST(LandmarkTable, NamesTheLineAtFault) {
  expectLandmarkFault("", "1: ", "header");
  expectLandmarkFault(landmarkFile("landmark,x,y", false), "1: ", "header");
  const std::string header = "landmark,x,y,z";
  expectLandmarkFault(landmarkFile(header, false, 4, "68,1,2,3"), "4: ", "no landmark number");
  expectLandmarkFault(landmarkFile(header, false, 4, "-1,1,2,3"), "4: ", "no landmark number");
  expectLandmarkFault(landmarkFile(header, false, 4, "1,1,2,3"), "4: ", "twice");
  expectLandmarkFault(landmarkFile(header, false, 4, "2,1,nan,3"), "4: ", "finite");
  expectLandmarkFault(landmarkFile(header, false, 4, "2,1,inf,3"), "4: ", "finite");
  expectLandmarkFault(landmarkFile(header, false, 4, "2,1"), "4: ", "2 cells under 4 columns");
  expectLandmarkFault(landmarkFile(header, false, 4, "2,1,2,3,4"), "4: ", "5 cells under 4 columns");
  expectLandmarkFault(landmarkFile("Landmark,x,y,z", false), "1: ", "'Landmark'");
  expectLandmarkFault(landmarkFile(header, false, 4, "2,1,2x,3"), "4: ", "finite");
  expectLandmarkFault(landmarkFile(header, false, 32, ""), "69: ", "landmark 30 (nose_tip) is missing");
  expectLandmarkFault(landmarkFile("landmark,vertex", true, 9, "7,1.5"), "9: ", "no vertex number");
}

TEST(LandmarkTable, LandmarksWithoutNamesMayBeMissing) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,x,y,z", false, 4, ""), table), "");
  EXPECT_FALSE(table.given[2]);
  EXPECT_TRUE(table.given[3]);
}

TEST(LandmarkTable, ReadsNames) {
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkFile("landmark,x,y,z", false, 32, "nose_tip,1,2,3"), table), "");
  EXPECT_EQ(table.positions[30], Eigen::Vector3d(1.0, 2.0, 3.0));
  expectLandmarkFault(landmarkFile("landmark,x,y,z", false, 33, "nose_tip,1,2,3"),
                      "33: ", "landmark 30 is given twice");
}

TEST(LandmarkTable, RowsWithoutNumbersCountFromZero) {
  std::string file = "x,y,z\n";
  for (int i = 0; i < 68; ++i) file += std::to_string(i) + ",0,0\n";
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(file, table), "");
  EXPECT_EQ(table.positions[67].x(), 67.0);
  expectLandmarkFault(file + "1,2,3\n", "70: ", "no landmark number");
}

TEST(LandmarkTable, MissingLandmarksFollowTheWarpOfTheOthers) {
  const FaceLandmarks reference = ellipticHead().landmarks();
  LandmarkTable::Given given{};
  for (int i = 0; i < FaceLandmarks::count; ++i) given[i] = !landmarkName(i).empty();
  Eigen::Matrix3d affine;
  affine << 0.0, -2.0, 0.1, 1.5, 0.0, 0.0, 0.0, 0.3, 1.0;
  FaceLandmarks expected;
  expected.points = (reference.points * affine.transpose()).rowwise() + Eigen::RowVector3d(5.0, 6.0, 7.0);
  FaceLandmarks landmarks = expected;
  for (int i = 0; i < FaceLandmarks::count; ++i)
    if (!given[i]) landmarks.points.row(i).setZero();
  ASSERT_EQ(completeLandmarks(reference, given, landmarks), "");
  EXPECT_LT((landmarks.points - expected.points).cwiseAbs().maxCoeff(), 1e-8) << "affine maps are reproduced exactly";
  FaceLandmarks flat;
  EXPECT_NE(completeLandmarks(flat, given, landmarks), "");
}

TEST(LandmarkTable, TextReadsBackToTheBit) {
  const FaceLandmarks landmarks = ellipticHead().landmarks();
  LandmarkTable table;
  ASSERT_EQ(parseLandmarks(landmarkText(landmarks), table), "");
  EXPECT_EQ(table.positions.points, landmarks.points);
}

TEST(LandmarkTable, PicturesNeedNoDepthButAllLandmarks) {
  FaceLandmarks landmarks;
  std::string file = "landmark,x,y\n";
  for (int i = 0; i < 67; ++i) file += std::to_string(i) + ",1,2\n";
  EXPECT_EQ(parsePictureLandmarks(file, landmarks), "68: landmark 67 is missing; all 68 are needed");
  ASSERT_EQ(parsePictureLandmarks(file + "67,3,4\n", landmarks), "");
  EXPECT_EQ(landmarks[67], Eigen::Vector3d(3.0, 4.0, 0.0));
}

TEST(LandmarkTable, AListOfAPictureMayHaveNoHeader) {
  std::string numbered, plain, named;
  for (int i = 0; i < 68; ++i) {
    const std::string place = std::to_string(2 * i) + ".5," + std::to_string(-i) + "\r\n";
    plain += place;
    numbered = std::to_string(i) + "," + place + numbered;  // in any order
    named += (i == 30 ? "nose_tip" : std::to_string(i)) + "," + place;
  }
  for (const std::string& file : {plain, numbered, named, "# a remark\n" + plain, "\xEF\xBB\xBF" + numbered}) {
    FaceLandmarks landmarks;
    ASSERT_EQ(parsePictureLandmarks(file, landmarks), "") << file.substr(0, 20);
    EXPECT_EQ(landmarks[0], Eigen::Vector3d(0.5, 0.0, 0.0));
    EXPECT_EQ(landmarks[67], Eigen::Vector3d(134.5, -67.0, 0.0));
  }
}

TEST(LandmarkTable, FaultsOfAListWithoutHeaderNameTheirLine) {
  const auto faultOf = [](const std::string& file) {
    FaceLandmarks landmarks;
    return parsePictureLandmarks(file, landmarks);
  };
  EXPECT_EQ(faultOf("0,1,2\n1,1,2\n").rfind("2: landmark 2 is missing", 0), 0u);
  EXPECT_EQ(faultOf("0,1,2\n1,1\n").rfind("2: there are 2 cells under 3 columns", 0), 0u);
  EXPECT_EQ(faultOf("0.5,1,2\n").rfind("1: '0.5' is no landmark", 0), 0u);
  EXPECT_EQ(faultOf("0,1,2,3\n").rfind("1: the header must name", 0), 0u) << "places in space are no picture";
  EXPECT_EQ(faultOf("0,x,2\n").rfind("1: the header must name", 0), 0u);
  LandmarkTable table;
  EXPECT_EQ(parseLandmarks("0,1,2,3\n", table).rfind("1: the header must name", 0), 0u) << "scans need theirs";
}
