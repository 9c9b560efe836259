#include <gtest/gtest.h>

#include "AnalyticJets.h"
#include "Degree.h"
#include "SeamMeasures.h"
#include "SeamSummary.h"

using namespace mien;

namespace {

constexpr double tolerance = 1e-9;

/// A plane through the x axis that rises by `slope` (radians) along y, its u of length `speed`.
SurfaceJet planeJet(double slope, double speed) {
  SurfaceJet jet;
  jet.su = speed * Eigen::Vector3d(0.0, -std::cos(slope), std::sin(slope));
  jet.sv = Eigen::Vector3d::UnitX();
  return jet;
}

}  // namespace

// Both contain the circle of radius 40; at it their meridians are at asin(40/R) from the axis.
TEST(SeamMeasures, OfTwoSpheresThatMeetInACircle) {
  const double R = 80.0, r = 50.0, circle = 40.0, speed = 1.5;
  const double angleR = std::asin(circle / R), angler = std::asin(circle / r);
  const double heightR = -R * std::cos(angleR), heightr = -r * std::cos(angler);
  for (const double v : {0.0, 1.0, 4.0})
    for (const double shear : {0.0, 0.7}) {
      const SurfaceJet before = sphereJet(R, heightR, angleR, speed, v),
                       after = sphereJet(r, heightr, angler, speed, v);
      const SeamMeasures measures(sheared(before, shear), sheared(after, shear));
      EXPECT_NEAR(measures.g0, 0.0, tolerance);
      EXPECT_NEAR(measures.g1, (angler - angleR) / degree, tolerance);
      EXPECT_NEAR(measures.g2, 1.0 / r - 1.0 / R, tolerance);
    }
  // at no shear |S_u| = radius x speed and |S_uu| = radius x speed^2, and the angle between both is that of the
  // meridians
  const SeamMeasures measures(sphereJet(R, heightR, angleR, speed, 1.0), sphereJet(r, heightr, angler, speed, 1.0));
  const double jump = std::sqrt(R * R + r * r - 2.0 * R * r * std::cos(angler - angleR)) / (0.5 * (R + r));
  EXPECT_NEAR(measures.c1, jump, tolerance);
  EXPECT_NEAR(measures.c2, jump, tolerance);
}

TEST(SeamMeasures, OfAConeOnACylinder) {
  const double half = 20.0 * degree;
  for (const double shear : {0.0, 0.02}) {
    const SurfaceJet cone = revolutionJet({40.0, 3.0 * std::sin(half), 0.0}, {0.0, -3.0 * std::cos(half), 0.0}, 0.8);
    const SurfaceJet cylinder = revolutionJet({40.0, 0.0, 0.0}, {0.0, -6.0, 0.0}, 0.8);
    const SeamMeasures measures(sheared(cone, shear), sheared(cylinder, shear));
    EXPECT_NEAR(measures.g0, 0.0, tolerance);
    EXPECT_NEAR(measures.g1, 20.0, tolerance);
    EXPECT_NEAR(measures.g2, 0.0, tolerance);  // both meridians are straight
    if (shear != 0.0) continue;
    EXPECT_NEAR(measures.c1, std::sqrt(9.0 + 36.0 - 36.0 * std::cos(half)) / 4.5, tolerance);
    EXPECT_EQ(measures.c2, 0.0);
  }
}

TEST(SeamMeasures, OfAPlanarFoldOf30Degrees) {
  SurfaceJet after = planeJet(30.0 * degree, 2.0);
  const SeamMeasures fold(planeJet(0.0, 2.0), after);
  EXPECT_EQ(fold.g0, 0.0);
  EXPECT_NEAR(fold.g1, 30.0, tolerance);
  EXPECT_NEAR(fold.c1, 2.0 * std::sin(15.0 * degree), tolerance);
  EXPECT_EQ(fold.g2, 0.0);
  EXPECT_EQ(fold.c2, 0.0);
  after.s.z() += 3.0;
  EXPECT_NEAR(SeamMeasures(planeJet(0.0, 2.0), after).g0, 3.0, tolerance);
}

TEST(SeamMeasures, TellGeometricFromParametricContinuity) {
  const SeamMeasures faster(planeJet(0.0, 1.0), planeJet(0.0, 3.0));
  EXPECT_NEAR(faster.g1, 0.0, tolerance);
  EXPECT_NEAR(faster.c1, 1.0, tolerance);
}

TEST(SeamMeasures, ResolveAnglesFarBelowTheArcCosine) {
  EXPECT_NEAR(SeamMeasures(planeJet(0.0, 1.0), planeJet(1e-10, 1.0)).g1, 1e-10 / degree, 1e-16);
}

TEST(SeamSummary, LeavesUndefinedMeasuresOut) {
  SeamSummary summary;
  EXPECT_TRUE(std::isnan(summary.max().g1));
  EXPECT_TRUE(std::isnan(summary.mean().g0));
  SurfaceJet crease = planeJet(0.0, 1.0);
  crease.su.setZero();
  summary.add(SeamMeasures(planeJet(0.0, 1.0), planeJet(10.0 * degree, 1.0)));
  summary.add(SeamMeasures(planeJet(0.0, 1.0), crease));
  summary.add(SeamMeasures(planeJet(0.0, 1.0), planeJet(30.0 * degree, 1.0)));
  EXPECT_EQ(summary.count(), 3);
  EXPECT_NEAR(summary.max().g1, 30.0, tolerance);
  EXPECT_NEAR(summary.mean().g1, 20.0, tolerance);
  EXPECT_NEAR(summary.max().c1, 2.0, tolerance);  // a slope against none
  SeamSummary both = summary;
  both.add(summary);
  EXPECT_EQ(both.count(), 6);
  EXPECT_NEAR(both.mean().g1, 20.0, tolerance);
}
