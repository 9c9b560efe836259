#include <gtest/gtest.h>

#include "Degree.h"
#include "EarlessSkin.h"
#include "SyntheticHead.h"

using namespace mien;

namespace {

/// Ears of 30 mm at 90 to 115 degrees of azimuth and 60 mm of height.
SyntheticHead headWithEars() {
  SyntheticHead head = ellipticHead();
  const auto skull = head.radius;
  head.radius = [skull](double azimuth, double y) {
    const double a = std::abs(std::remainder(azimuth, 2.0 * M_PI)) / degree;
    const bool ear = a > 90.0 && a < 115.0 && y > -20.0 && y < 40.0;
    return skull(azimuth, y) + (ear ? 30.0 : 0.0);
  };
  return head;
}

}  // namespace

TEST(EarlessSkin, TakesTheEarsOff) {
  const SyntheticHead head = headWithEars(), skull = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  const RadialSkin skin(mesh, head.axis);
  const EarlessSkin earless(skin, -70.0, 110.0);
  double largest = 0.0;
  for (double azimuth = 80.0; azimuth < 130.0; azimuth += 1.0)
    for (double y = -40.0; y < 60.0; y += 5.0)
      largest = std::max(largest, std::abs(earless.radius(azimuth * degree, y) - skull.radius(azimuth * degree, y)));
  EXPECT_GT(skin.radius(100.0 * degree, 0.0) - skull.radius(100.0 * degree, 0.0), 29.0);
  EXPECT_LT(largest, 2.0);  // the opening follows the narrow side of a sloping skull
}

TEST(EarlessSkin, IsTheMeshItselfInFront) {
  const SyntheticHead head = headWithEars();
  const TriangleMesh mesh = head.mesh();
  const RadialSkin skin(mesh, head.axis);
  const EarlessSkin earless(skin, -70.0, 110.0);
  for (double azimuth = -60.0; azimuth <= 60.0; azimuth += 3.3)
    EXPECT_EQ(earless.radius(azimuth * degree, 12.3), skin.radius(azimuth * degree, 12.3));
}

TEST(EarlessSkin, KeepsTheBackOfTheHead) {
  const SyntheticHead head = ellipticHead();
  const TriangleMesh mesh = head.mesh();
  const RadialSkin skin(mesh, head.axis);
  const EarlessSkin kept(skin, -70.0, 110.0);
  for (double azimuth = 130.0; azimuth <= 230.0; azimuth += 4.0)
    EXPECT_NEAR(kept.radius(azimuth * degree, 20.0), head.radius(azimuth * degree, 20.0), 0.5);
}
