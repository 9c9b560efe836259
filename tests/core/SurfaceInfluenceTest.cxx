#include <gtest/gtest.h>

#include "FaceSample.h"
#include "RandomCurves.h"
#include "SchemeOptions.h"
#include "SurfaceInfluence.h"

using namespace mien;

namespace {

constexpr int gridColumns = 40;

RowMajor<double> influenceOf(const std::string& scheme, const InfluenceSource& source, double a = 1.0) {
  return surfaceInfluence(optionsFor(scheme, a), 40, RowLayout(56, false), gridColumns, source);
}

}  // namespace

TEST(SurfaceInfluence, IsTheDifferenceOfTwoSurfaces) {
  for (const FaceScheme& scheme : faceSchemes())
    for (const int point : {InfluenceSource::wholeCurve, 17}) {
      const FaceCurves face = randomFace();
      FaceCurves moved = face;
      const Eigen::RowVector3d move(0.5, -1.0, 2.0);
      for (int j = 0; j < 40; ++j)
        if (point < 0 || j == point) moved.curves.curve(12).row(j) += move;
      const FaceSample before(face, optionsFor(scheme.name), 56, gridColumns),
          after(moved, optionsFor(scheme.name), 56, gridColumns);
      const RowMajor<double> influence = influenceOf(scheme.name, {12, point});
      const RowLayout layout(56, false);
      for (int patch = 0; patch < FaceLayout::patchCount; ++patch)
        for (int row = before.firstRow(patch) + 1; row < before.firstRow(patch + 1); ++row) {
          int gridRow = 0;
          while (layout.rows()[gridRow].patch != patch || layout.rows()[gridRow].u != before.u(row)) ++gridRow;
          for (int column = 0; column < gridColumns; ++column) {
            const Eigen::Vector3d difference = after.point(row, column) - before.point(row, column);
            ASSERT_LT((difference - influence(gridRow, column) * move.transpose()).norm(), 1e-11) << scheme.name;
          }
        }
    }
}

TEST(SurfaceInfluence, OfAllCurvesTogetherMovesTheWholeFace) {
  for (const FaceScheme& scheme : faceSchemes()) {
    RowMajor<double> sum = influenceOf(scheme.name, {0});
    for (int curve = 1; curve < FaceLayout::curveCount; ++curve) sum += influenceOf(scheme.name, {curve});
    EXPECT_LT((sum.array() - 1.0).abs().maxCoeff(), 1e-12) << scheme.name;
  }
}

TEST(SurfaceInfluence, OfAllPointsIsThatOfTheCurve) {
  RowMajor<double> sum = influenceOf("spline", {9, 0});
  for (int point = 1; point < 40; ++point) sum += influenceOf("spline", {9, point});
  EXPECT_LT((sum - influenceOf("spline", {9})).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SurfaceInfluence, ReachesOnePatchInFourCurveAndFadesInSpline) {
  const RowLayout layout(56, false);
  const InfluenceProfile fourCurve(influenceOf("four-curve", {10}), layout, 10),
      spline(influenceOf("spline", {10}), layout, 10);
  for (size_t row = 0; row < 56; ++row) {
    const double away = std::abs(spline.position[row] - 10.0);
    if (fourCurve.position[row] < 9.0 || fourCurve.position[row] > 12.0) {
      EXPECT_EQ(fourCurve.largest[row], 0.0);
    }
    if (away < 1e-9) {
      EXPECT_NEAR(spline.largest[row], 1.0, 1e-12);
    } else if (away > 3.0) {
      EXPECT_LT(spline.largest[row], 0.05);  // a spline's cardinal function falls by 0.27 per knot
    }
  }
  EXPECT_GT(spline.curvesAbove, 0.4);
  EXPECT_LT(spline.curvesAbove, 0.8);
  EXPECT_NEAR(spline.curvesBelow, spline.curvesAbove, 0.02);
  EXPECT_NEAR(spline.rowsBelow, 2.0 * spline.curvesBelow, 1e-9);  // two rows per interval at 56
}

TEST(SurfaceInfluence, OfAPointIsForgottenSoonerAtLargerA) {
  const RowLayout layout(218, false);
  double last = 1.0;
  for (const double a : {1.0, 3.0, 10.0}) {
    const auto influence = surfaceInfluence(optionsFor("spline", a), 40, layout, gridColumns, {12, 20});
    const double width = InfluenceProfile(influence, layout, 12).curvesAbove;
    EXPECT_LT(width, last) << a;
    last = width;
  }
}

TEST(InfluenceProfile, HalfWidthsOfAHandMadeProfile) {
  const RowLayout layout(29, false);  // one row per curve
  RowMajor<double> influence = RowMajor<double>::Zero(29, 3);
  influence(5, 1) = -2.0;
  influence(6, 0) = 1.5;
  influence(7, 2) = 0.5;
  influence(4, 2) = 0.0;
  const InfluenceProfile profile(influence, layout, 5);
  EXPECT_EQ(profile.largest[5], 2.0);
  EXPECT_NEAR(profile.curvesBelow, 1.5, 1e-12);
  EXPECT_NEAR(profile.rowsBelow, 1.5, 1e-12);
  EXPECT_NEAR(profile.curvesAbove, 0.5, 1e-12);
  influence.setOnes();
  EXPECT_TRUE(std::isnan(InfluenceProfile(influence, layout, 5).curvesAbove));
}
