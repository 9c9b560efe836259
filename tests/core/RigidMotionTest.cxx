#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <random>
#include <vector>

#include "RigidMotion.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

using Points = ClosedCurves::Points;

Points turned(const Points& points, double angle, const Eigen::Vector3d& shift) {
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d(0.2, 1.0, -0.4).normalized()).matrix();
  return (points * rotation.transpose()).rowwise() + shift.transpose();
}

/// A head whose lowest points, a share of all, are drawn down and forward, the lower the further: up to 15 mm.
Points jawDropped(const Points& head, double share) {
  std::vector<double> heights(head.rows());
  for (Eigen::Index i = 0; i < head.rows(); ++i) heights[i] = head(i, 1);
  std::sort(heights.begin(), heights.end());
  const double lowest = heights.front(), border = heights[static_cast<size_t>(share * (head.rows() - 1))];
  Points moved = head;
  for (Eigen::Index i = 0; i < head.rows(); ++i) {
    const double depth = std::max(0.0, border - head(i, 1)) / (border - lowest);
    moved.row(i) += 15.0 * depth * Eigen::RowVector3d(0.1, -0.9, 0.4);
  }
  return moved;
}

double largestStillMotion(const Points& head, const Points& moved, const Points& restored) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < head.rows(); ++i)
    if (moved.row(i) == head.row(i)) largest = std::max(largest, (restored.row(i) - head.row(i)).norm());
  return largest;
}

}  // namespace

TEST(RigidMotion, FindsTheMotionOfAHead) {
  const ClosedCurves::Points head = SyntheticFace::make().curves.points;
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.2, 1.0, -0.4).normalized()).matrix();
  const Eigen::Vector3d shift(12.0, -7.0, 30.0);
  const ClosedCurves::Points moved = (head * rotation.transpose()).rowwise() + shift.transpose();
  const RigidMotion motion = fitRigidMotion(head, moved);
  EXPECT_LT((motion.rotation - rotation).norm(), 1e-12);
  EXPECT_LT((motion.translation - shift).norm(), 1e-10);
  EXPECT_NEAR(motion.angle(), 0.7, 1e-12);
  EXPECT_LT((motion.undone(moved) - head).rowwise().norm().maxCoeff(), 1e-10);
}

TEST(RigidMotion, NeverReflects) {
  const ClosedCurves::Points head = SyntheticFace::make().curves.points;
  ClosedCurves::Points inverted = head;
  inverted.col(2) *= -1.0;
  EXPECT_NEAR(fitRigidMotion(head, inverted).rotation.determinant(), 1.0, 1e-12);
  EXPECT_EQ(fitRigidMotion(ClosedCurves::Points(0, 3), ClosedCurves::Points(0, 3)).translation.norm(), 0.0);
}

TEST(RigidMotion, TheStillPartTellsTheMotionOfAHeadWhosePartsMove) {
  const Points head = SyntheticFace::make().curves.points;
  for (const double share : {0.3, 0.5})
    for (const double angle : {0.0, 0.05, 0.6}) {
      const Points deformed = jawDropped(head, share), moved = turned(deformed, angle, {12.0, -7.0, 30.0});
      const RigidMotion motion = fitStillPart(head, moved);
      EXPECT_NEAR(motion.angle(), angle, 1e-8);
      EXPECT_LT((motion.undone(moved) - deformed).rowwise().norm().maxCoeff(), 1e-6) << share << " " << angle;
      EXPECT_GT((fitRigidMotion(head, moved).undone(moved) - deformed).rowwise().norm().maxCoeff(), 0.5);
    }
}

TEST(RigidMotion, AStillHeadStaysStillWhateverItsFaceDoes) {
  const Points head = SyntheticFace::make().curves.points, moved = jawDropped(head, 0.6);
  EXPECT_LT(largestStillMotion(head, moved, fitStillPart(head, moved).undone(moved)), 1e-6);
}

TEST(RigidMotion, NoiseOfAScanMovesTheFitLessThanItself) {
  const Points head = SyntheticFace::make().curves.points;
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, 0.1);
  Points deformed = jawDropped(head, 0.3), moved = turned(deformed, 0.2, {5.0, 1.0, -3.0});
  for (Eigen::Index i = 0; i < moved.size(); ++i) moved.data()[i] += noise(random);
  const Points restored = fitStillPart(head, moved).undone(moved);
  EXPECT_LT((restored - deformed).colwise().mean().norm(), 0.05);
  EXPECT_EQ(fitStillPart(head, moved).undone(moved), restored) << "nothing is random";
  EXPECT_EQ(fitStillPart(Points(0, 3), Points(0, 3)).translation.norm(), 0.0);
}
