#include <gtest/gtest.h>

#include "AnalyticJets.h"
#include "SurfaceCurvature.h"

using namespace mien;

TEST(SurfaceCurvature, OfASphereIsPositiveSeenFromOutside) {
  for (const double shear : {0.0, -0.8, 2.0})
    for (double angle = 0.3; angle < 3.0; angle += 0.4) {
      const SurfaceCurvature curvature(sheared(sphereJet(80.0, 12.0, angle, 1.7, 2.1), shear));
      EXPECT_NEAR(curvature.mean, 1.0 / 80.0, 1e-15);
      EXPECT_NEAR(curvature.gaussian, 1.0 / 6400.0, 1e-16);
      EXPECT_NEAR(curvature.maximum, 1.0 / 80.0, 1e-15);
      EXPECT_NEAR(curvature.minimum, 1.0 / 80.0, 1e-15);
    }
}

TEST(SurfaceCurvature, OfATorusHasBothSigns) {
  const double R = 50.0, r = 20.0;
  for (const double shear : {0.0, 1.3})
    for (double angle = -2.9; angle < 3.0; angle += 0.37) {
      const SurfaceCurvature curvature(sheared(circleJet(R, r, 0.0, angle, 0.6, 0.4), shear));
      const double aroundAxis = std::sin(angle) / (R + r * std::sin(angle)), aroundTube = 1.0 / r;
      EXPECT_NEAR(curvature.maximum, aroundTube, 1e-15);
      EXPECT_NEAR(curvature.minimum, aroundAxis, 1e-15);
      EXPECT_NEAR(curvature.mean, 0.5 * (aroundTube + aroundAxis), 1e-15);
      EXPECT_NEAR(curvature.gaussian, aroundTube * aroundAxis, 1e-16);
    }
}

TEST(SurfaceCurvature, AcrossASeamIsThatOfTheProfile) {
  for (const double shear : {0.0, 0.9})
    EXPECT_NEAR(curvatureAcross(sheared(circleJet(50.0, 20.0, 0.0, -1.0, 0.6, 0.4), shear)), 1.0 / 20.0, 1e-15);
}

TEST(SurfaceCurvature, IsUndefinedWithoutATangentPlane) {
  SurfaceJet jet = sphereJet(80.0, 0.0, 1.0, 1.0, 0.5);
  jet.sv = 0.25 * jet.su;
  EXPECT_TRUE(unitNormal(jet).hasNaN());
  EXPECT_TRUE(std::isnan(SurfaceCurvature(jet).mean));
  EXPECT_TRUE(std::isnan(SurfaceCurvature(jet).minimum));
}
