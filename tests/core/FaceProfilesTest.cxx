#include <gtest/gtest.h>

#include "Degree.h"
#include "FaceLayout.h"
#include "FaceProfiles.h"
#include "SyntheticHead.h"

using namespace mien;

TEST(FaceProfiles, CurvesNeverCrossAtAnyAzimuth) {
  const FaceProfiles profiles(ellipticHead().landmarks());
  for (double azimuth = -180.0; azimuth <= 180.0; azimuth += 0.5)
    for (int c = 0; c + 1 < FaceLayout::curveCount; ++c) {
      const double gap = profiles.height(c, azimuth * degree) - profiles.height(c + 1, azimuth * degree);
      if (c == FaceLayout::upperLip) {
        EXPECT_EQ(gap, 0.0);
      } else
        EXPECT_GT(gap, 1.0) << FaceLayout::curveName(c) << " at " << azimuth;
    }
}

TEST(FaceProfiles, KeyCurvesPassTheirLandmarks) {
  const FaceLandmarks landmarks = ellipticHead().landmarks();
  const FaceProfiles profiles(landmarks);
  const auto height = [&](const char* curve, int landmark) {
    return profiles.height(FaceLayout::curveIndex(curve), profiles.axis().azimuth(landmarks[landmark]));
  };
  for (const int brow : {18, 19, 20, 21, 22, 23, 24, 25}) EXPECT_NEAR(height("C6", brow), landmarks[brow].y(), 1e-9);
  for (const int lid : {37, 38, 43, 44}) EXPECT_NEAR(height("C9", lid), landmarks[lid].y(), 1e-9);
  for (const int lid : {40, 41, 46, 47}) EXPECT_NEAR(height("C10", lid), landmarks[lid].y(), 1e-9);
  for (const int lip : {49, 50, 51, 52, 53}) EXPECT_NEAR(height("C21", lip), landmarks[lip].y(), 1e-9);
  for (const int lip : {55, 56, 57, 58, 59}) EXPECT_NEAR(height("C23", lip), landmarks[lip].y(), 1e-9);
  for (const int corner : {48, 54}) EXPECT_NEAR(height("C22", corner), landmarks[corner].y(), 1e-9);
  EXPECT_NEAR(height("C15", 30), landmarks[30].y(), 1e-9);
  EXPECT_NEAR(height("C18", 33), landmarks[33].y(), 1e-9);
}

TEST(FaceProfiles, SpacingIsEvenAtTheBack) {
  const FaceProfiles profiles(ellipticHead().landmarks());
  const double step = (profiles.height(0, M_PI) - profiles.height(28, M_PI)) / 27.0;
  for (int c = 0; c < FaceLayout::upperLip; ++c)
    EXPECT_NEAR(profiles.height(c, M_PI) - profiles.height(c + 1, M_PI), step, 1e-9);
}

TEST(FaceProfiles, HeightsAreContinuousAroundTheHead) {
  const FaceProfiles profiles(ellipticHead().landmarks());
  for (int c = 0; c < FaceLayout::curveCount; ++c) {
    EXPECT_NEAR(profiles.height(c, -M_PI), profiles.height(c, M_PI), 1e-9);
    for (double azimuth = -180.0; azimuth < 180.0; azimuth += 0.1)
      EXPECT_NEAR(profiles.height(c, azimuth * degree), profiles.height(c, (azimuth + 0.1) * degree), 0.25);
  }
}
