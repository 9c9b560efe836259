#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "RigidMotion.h"
#include "SyntheticFace.h"

using namespace mien;

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
