#include <gtest/gtest.h>

#include "PupilNormalisation.h"

using namespace mien;

TEST(PupilNormalisation, PutsThePupilsAtPlusAndMinusOne) {
  PupilNormalisation pupils;
  const Eigen::Vector3d left(33.0, 42.0, 80.0), right(-27.0, 30.0, 84.0);
  ASSERT_EQ(pupils.set(left, right), "");
  EXPECT_LT((pupils.apply(left).head<2>() - Eigen::Vector2d(1.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((pupils.apply(right).head<2>() - Eigen::Vector2d(-1.0, 0.0)).norm(), 1e-15);
  EXPECT_NEAR(pupils.unit(), 0.5 * std::hypot(60.0, 12.0), 1e-13);
}

TEST(PupilNormalisation, InvertGoesBack) {
  PupilNormalisation pupils;
  ASSERT_EQ(pupils.set({33.0, 42.0, 80.0}, {-27.0, 30.0, 84.0}), "");
  const Eigen::Vector3d point(12.0, -50.0, 101.0);
  EXPECT_LT((pupils.invert(pupils.apply(point)) - point).norm(), 1e-13);
  EXPECT_GT((pupils.apply(point) - point).norm(), 1.0);
}

TEST(PupilNormalisation, RefusesPupilsThatCannotServe) {
  PupilNormalisation pupils;
  EXPECT_NE(pupils.set({3.0, 4.0, 5.0}, {3.0, 4.0, 9.0}).find("coincide"), std::string::npos);
  EXPECT_NE(pupils.set({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}).find("coincide"), std::string::npos);
  EXPECT_NE(pupils.set({NAN, 0.0, 0.0}, {1.0, 0.0, 0.0}).find("finite"), std::string::npos);
}
