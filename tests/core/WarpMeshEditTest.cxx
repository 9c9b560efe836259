#include <gtest/gtest.h>

#include <cmath>

#include "WarpMeshEdit.h"

namespace {

const mien::WarpMesh mesh = mien::evenMesh(7, 7, 600.0, 300.0);  // 100 x 50 pixels between points

TEST(WarpMeshEdit, FindsTheNearestPointWithinReach) {
  EXPECT_EQ(mien::nearestNode(mesh, 204.0, 97.0, 6.0), (mien::MeshNode{2, 2}));
  EXPECT_EQ(mien::nearestNode(mesh, 204.0, 97.0, 4.0), mien::MeshNode());
  EXPECT_EQ(mien::nearestNode(mesh, 160.0, 100.0, 100.0), (mien::MeshNode{2, 2}));
}

TEST(WarpMeshEdit, MovesOnePointAndNoOther) {
  mien::WarpMesh moved = mesh;
  EXPECT_EQ(mien::moveNode(moved, {3, 1}, 130.0, 160.0, false), "");
  EXPECT_EQ(moved.x(3, 1), 130.0);
  EXPECT_EQ(moved.y(3, 1), 160.0);
  EXPECT_EQ((moved.x - mesh.x).cwiseAbs().sum() + (moved.y - mesh.y).cwiseAbs().sum(), 40.0);
}

TEST(WarpMeshEdit, TheOtherSideMovesAsTheMirrorImage) {
  mien::WarpMesh moved = mesh;
  EXPECT_EQ(mien::moveNode(moved, {3, 1}, 130.0, 160.0, true), "");
  EXPECT_EQ(moved.x(3, 5), 470.0);
  EXPECT_EQ(moved.y(3, 5), 160.0);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j) EXPECT_EQ(moved.x(i, j), 600.0 - moved.x(i, 6 - j));
  EXPECT_EQ(mien::moveNode(moved, {2, 3}, 320.0, 100.0, true), "");
  EXPECT_EQ(moved.x(2, 3), 320.0);
}

TEST(WarpMeshEdit, AFoldIsRefusedAndLeavesTheMesh) {
  mien::WarpMesh moved = mesh;
  const std::string columns = mien::moveNode(moved, {3, 1}, 210.0, 150.0, false);
  EXPECT_NE(columns.find("columns 2 and 3 cross in row 4"), std::string::npos) << columns;
  const std::string rows = mien::moveNode(moved, {3, 1}, 100.0, 90.0, false);
  EXPECT_NE(rows.find("rows 3 and 4 cross in column 2"), std::string::npos) << rows;
  EXPECT_NE(mien::moveNode(moved, {3, 2}, 320.0, 150.0, true), "");
  EXPECT_TRUE(moved == mesh);
}

TEST(WarpMeshEdit, PlacesBesideTheImageAreBroughtToItsBorder) {
  mien::WarpMesh moved = mesh;
  EXPECT_EQ(mien::moveNode(moved, {6, 6}, 900.0, 1000.0, false), "");
  EXPECT_EQ(moved.x(6, 6), 600.0);
  EXPECT_EQ(moved.y(6, 6), 300.0);
}

TEST(WarpMeshEdit, PointsThatAreNotThereAndPlacesWithoutNumbersAreRefused) {
  mien::WarpMesh moved = mesh;
  EXPECT_NE(mien::moveNode(moved, {7, 0}, 1.0, 1.0, false), "");
  EXPECT_NE(mien::moveNode(moved, mien::MeshNode(), 1.0, 1.0, false), "");
  EXPECT_NE(mien::moveNode(moved, {1, 1}, std::nan(""), 1.0, false), "");
  EXPECT_TRUE(moved == mesh);
}

}  // namespace
