#include <gtest/gtest.h>

#include <cmath>

#include "FAPTable.h"
#include "HeadRotation.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

const Eigen::Vector3d spine(0.0, -60.0, 0.0);

Eigen::RowVector3d turned(int fap, double value, const Eigen::RowVector3d& fromSpine) {
  FAPFrame frame;
  frame.setValue(fap, value);
  ClosedCurves::Points point = fromSpine + spine.transpose();
  HeadRotation(frame, spine).apply(point);
  return point.row(0) - spine.transpose();
}

}  // namespace

TEST(HeadRotation, TurnsBy1e5thOfARadianInTheStandardsDirections) {
  const double angle = 0.3, c = std::cos(angle), s = std::sin(angle), value = angle * 1e5;
  const Eigen::RowVector3d nose(0, 0, 1), top(0, 1, 0);
  EXPECT_LT((turned(48, value, nose) - Eigen::RowVector3d(0, -s, c)).norm(), 1e-13) << "the face turns down";
  EXPECT_LT((turned(49, value, nose) - Eigen::RowVector3d(s, 0, c)).norm(), 1e-13) << "to the subject's left";
  EXPECT_LT((turned(50, value, top) - Eigen::RowVector3d(-s, c, 0)).norm(), 1e-13) << "to the subject's right";
}

TEST(HeadRotation, IsUndoneAndMirrored) {
  FAPFrame frame;
  frame.setValue(48, 20000.0);
  frame.setValue(49, -35000.0);
  frame.setValue(50, 12000.0);
  const ClosedCurves::Points neutral = SyntheticFace::make().curves.points;
  ClosedCurves::Points head = neutral, image = neutral;
  image.col(0) *= -1.0;
  HeadRotation(frame, spine).apply(head);
  HeadRotation(mirrored(frame), spine).apply(image);
  image.col(0) *= -1.0;
  EXPECT_LT((head - image).rowwise().norm().maxCoeff(), 1e-11);
  EXPECT_GT((head - neutral).rowwise().norm().maxCoeff(), 10.0);
  HeadRotation(frame, spine).undo(head);
  EXPECT_LT((head - neutral).rowwise().norm().maxCoeff(), 1e-11);
}

TEST(HeadRotation, ZeroKeepsEveryBit) {
  const ClosedCurves::Points neutral = SyntheticFace::make().curves.points;
  ClosedCurves::Points head = neutral;
  HeadRotation(FAPFrame(), spine).apply(head);
  EXPECT_EQ(head, neutral);
}
