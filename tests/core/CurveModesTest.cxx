#include <gtest/gtest.h>

#include "CurveModes.h"
#include "RandomCurves.h"
#include "SyntheticFace.h"

using namespace mien;

TEST(CurveModes, AllModesAreTheCurves) {
  const FaceCurves face = randomFace();
  EXPECT_LT((firstModes(face.curves, 20).points - face.curves.points).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(CurveModes, AModeThatIsThereIsKeptAndOthersAreNot) {
  ClosedCurves curves(29, 16);
  for (int c = 0; c < 29; ++c)
    for (int j = 0; j < 16; ++j) {
      const double v = 2.0 * M_PI * j / 16;
      curves.curve(c).row(j) << std::sin(2 * v) + std::cos(5 * v), -10.0 * c, std::cos(3 * v);
    }
  const ClosedCurves two = firstModes(curves, 2), three = firstModes(curves, 3);
  for (int j = 0; j < 16; ++j) {
    const double v = 2.0 * M_PI * j / 16;
    EXPECT_NEAR(two.curve(7)(j, 0), std::sin(2 * v), 1e-12);
    EXPECT_NEAR(two.curve(7)(j, 2), 0.0, 1e-12);
    EXPECT_NEAR(three.curve(7)(j, 2), std::cos(3 * v), 1e-12);
  }
}

TEST(CurveModes, MoreModesComeNearerAndStayInOrder) {
  FaceCurves face = SyntheticFace::make();
  const ClosedCurves whole = face.curves;
  double before = 1e9;
  for (int n = 0; n <= 20; ++n) {
    face.curves = firstModes(whole, n);
    const double distance = (face.curves.points - whole.points).norm();
    EXPECT_LE(distance, before + 1e-9) << n;
    EXPECT_EQ(describeFault(face), "") << n;
    before = distance;
  }
  EXPECT_LT(before, 1e-9);
}

TEST(CurveModes, NumbersAreThoseOfThePaper) {
  EXPECT_EQ(modeNumberCount(40, 5) * 4, 3828);
  EXPECT_EQ(modeNumberCount(40, 20) * 4, 13920);
  EXPECT_EQ(modeNumberCount(40, 19) * 4, 29 * 39 * 12);
}
