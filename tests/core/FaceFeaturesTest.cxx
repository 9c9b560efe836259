#include <gtest/gtest.h>

#include "FaceAcquisition.h"
#include "FaceFeatures.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

struct MeasuredHead {
  FaceLandmarks landmarks = ellipticHead().landmarks();
  FaceCurves face;

  MeasuredHead() { EXPECT_EQ(acquireFace(ellipticHead().mesh(), landmarks, 40, face), ""); }
  Eigen::Vector3d at(const std::string& id) const {
    const FeaturePoint* feature = face.feature(id);
    EXPECT_NE(feature, nullptr) << id;
    return feature ? face.curves.at(feature->curve, feature->v) : Eigen::Vector3d::Zero();
  }
};

}  // namespace

TEST(FaceFeatures, AddressesGiveTheLandmarksTheyStandFor) {
  const MeasuredHead head;
  const std::pair<const char*, int> expected[] = {{"8.3", 54}, {"8.4", 48}, {"4.1", 22},  {"4.2", 21},  {"4.5", 26},
                                                  {"3.7", 45}, {"3.8", 39}, {"3.11", 42}, {"3.12", 36}, {"8.10", 52}};
  for (const auto& [id, landmark] : expected) EXPECT_NEAR(head.at(id).x(), head.landmarks[landmark].x(), 1e-6) << id;
}

TEST(FaceFeatures, PairsMirrorExactly) {
  const MeasuredHead head;
  const std::pair<const char*, const char*> pairs[] = {{"4.1", "4.2"}, {"8.3", "8.4"}, {"3.7", "3.12"},
                                                       {"3.1", "3.2"}, {"9.1", "9.2"}, {"5.1", "5.2"},
                                                       {"2.4", "2.5"}, {"8.10", "8.9"}};
  for (const auto& [left, right] : pairs) {
    EXPECT_EQ(head.face.feature(left)->v, 2.0 * M_PI - head.face.feature(right)->v);
    EXPECT_GT(head.at(left).x(), 0.0) << left;
  }
  for (const char* id : {"2.1", "2.2", "2.3", "2.10", "8.1", "8.2", "9.3", "9.15"})
    EXPECT_EQ(head.face.feature(id)->v, M_PI);
}

TEST(FaceFeatures, FollowTheConstraintsOfTheStandard) {
  const MeasuredHead head;
  EXPECT_NEAR(head.at("8.5").x(), 0.5 * head.at("8.3").x(), 1e-6);
  EXPECT_NEAR(head.at("8.7").x(), 0.5 * head.at("8.3").x(), 1e-6);
  EXPECT_NEAR(head.at("2.6").x(), 0.5 * head.at("2.4").x(), 1e-6);
  EXPECT_NEAR(head.at("3.1").x(), 0.5 * (head.at("3.7").x() + head.at("3.11").x()), 1e-6);
  EXPECT_NEAR(head.at("4.3").x(), 0.5 * (head.at("4.1").x() + head.at("4.5").x()), 1e-6);
  EXPECT_GT(head.at("5.3").x(), head.face.leftPupil.x());
  EXPECT_LT(head.at("5.3").x(), head.at("3.7").x());
  EXPECT_NEAR(head.at("5.1").y(), head.at("8.3").y(), 8.0);
  EXPECT_GT(head.at("9.12").y(), head.at("9.3").y());
}

TEST(FaceFeatures, AWidthNoCurveReachesGivesThePlaceWhereItIsWidest) {
  MeasuredHead head;
  head.landmarks.points.row(26).x() = 500.0;
  head.landmarks.points.row(17).x() = -500.0;
  for (const FeaturePoint& feature : locateFeatures(head.face.curves, head.landmarks)) {
    EXPECT_GE(feature.v, 0.0);
    EXPECT_LT(feature.v, 2.0 * M_PI);
  }
}
