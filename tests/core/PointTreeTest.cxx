#include <gtest/gtest.h>

#include <limits>

#include "PointTree.h"

using namespace mien;

TEST(PointTree, FindsWhatASearchOfAllPointsFinds) {
  std::srand(3);
  PointTree::Points points = PointTree::Points::Random(2000, 3);
  points.topRows(50) = points.bottomRows(50);  // places given twice
  const PointTree tree(points);
  for (int i = 0; i < 500; ++i) {
    const Eigen::RowVector3d place = 1.5 * Eigen::RowVector3d::Random();
    const double nearest = (points.rowwise() - place).rowwise().norm().minCoeff();
    const int found = tree.nearest(place, 10.0);
    ASSERT_GE(found, 0);
    EXPECT_NEAR((points.row(found) - place).norm(), nearest, 1e-14);
    EXPECT_EQ(tree.nearest(place, 0.99 * nearest), -1);
  }
}

TEST(PointTree, LeavesOutPointsThatAreNotFinite) {
  PointTree::Points points = PointTree::Points::Constant(3, 3, std::numeric_limits<double>::quiet_NaN());
  points.row(1).setOnes();
  EXPECT_EQ(PointTree(points).nearest(Eigen::RowVector3d::Zero(), 5.0), 1);
  EXPECT_EQ(PointTree(PointTree::Points(0, 3)).nearest(Eigen::RowVector3d::Zero(), 5.0), -1);
}
