#include <gtest/gtest.h>

#include "FaceLandmarks.h"
#include "SyntheticHead.h"

using namespace mien;

TEST(FaceLandmarks, AnAverageFaceHasNoFault) {
  EXPECT_EQ(describeFault(ellipticHead().landmarks()), "");
}

TEST(FaceLandmarks, TheAxisMovesAndScalesWithTheFace) {
  FaceLandmarks landmarks = ellipticHead().landmarks();
  const HeadAxis axis = headAxis(landmarks);
  EXPECT_NEAR(axis.x, 0.0, 1e-12);
  landmarks.points.rowwise() += Eigen::RowVector3d(10.0, 20.0, 30.0);
  EXPECT_NEAR(headAxis(landmarks).x, 10.0, 1e-12);
  EXPECT_NEAR(headAxis(landmarks).z, axis.z + 30.0, 1e-12);
  landmarks.points *= 2.0;
  EXPECT_NEAR(headAxis(landmarks).z, 2.0 * (axis.z + 30.0), 1e-11);
}

TEST(FaceLandmarks, ASwappedOrUpsideDownFaceIsRefused) {
  const FaceLandmarks right = ellipticHead().landmarks();
  FaceLandmarks mirrored = right, turned = right, missing = right;
  mirrored.points.col(0) *= -1.0;
  turned.points.col(1) *= -1.0;
  missing.points(40, 1) = NAN;
  EXPECT_NE(describeFault(mirrored).find("left"), std::string::npos);
  EXPECT_NE(describeFault(turned).find("brow above"), std::string::npos);
  EXPECT_NE(describeFault(missing).find("landmark 40"), std::string::npos);
}
