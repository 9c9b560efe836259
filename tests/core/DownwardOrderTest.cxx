#include <gtest/gtest.h>

#include "DownwardOrder.h"
#include "FaceCurves.h"
#include "RandomCurves.h"

using namespace mien;

TEST(DownwardOrder, CurvesInOrderStayToTheBit) {
  const FaceCurves face = randomFace();
  ASSERT_EQ(describeFault(face), "");
  ClosedCurves curves = face.curves;
  restoreDownwardOrder(curves);
  EXPECT_EQ(curves.points, face.curves.points);
}

TEST(DownwardOrder, CrossedCurvesComeIntoOrderAndNearerToCurvesThatWere) {
  const FaceCurves face = randomFace();
  for (const double noise : {1.0, 10.0, 100.0}) {
    std::srand(3);
    FaceCurves disturbed = face;
    disturbed.curves.points.col(1) += noise * Eigen::VectorXd::Random(disturbed.curves.points.rows());
    const double before = (disturbed.curves.points - face.curves.points).norm();
    ClosedCurves ordered = disturbed.curves;
    restoreDownwardOrder(ordered);
    EXPECT_LE((ordered.points - face.curves.points).norm(), before) << noise;
    EXPECT_EQ(ordered.points.col(0), disturbed.curves.points.col(0));
    EXPECT_EQ(ordered.points.col(2), disturbed.curves.points.col(2));
    EXPECT_NEAR(ordered.points.col(1).sum(), disturbed.curves.points.col(1).sum(), 1e-6);
    for (int c = 0; c + 1 < ordered.count; ++c)
      EXPECT_GE((ordered.curve(c).col(1) - ordered.curve(c + 1).col(1)).minCoeff(), 0.0) << noise;
  }
}
