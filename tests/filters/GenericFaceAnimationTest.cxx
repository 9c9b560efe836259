#include "AnimationData.h"
#include "BoundaryCurveData.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "FineColumns.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace mien;

namespace {

/// What the tests of FaceAnimator prove on a face of formulas, on the face that people see.
class GenericFaceAnimation : public testing::Test {
 protected:
  void SetUp() override {
    vtkNew<vtkBoundaryCurveReader> reader;
    reader->Update();
    ASSERT_EQ(readFaceCurves(reader->GetOutput(), face), "");
    AnimationTable table;
    ASSERT_EQ(readAnimationTable("", table), "");
    ASSERT_EQ(animator.bind(face, table), "");
  }

  FaceCurves face;
  FaceAnimator animator;
};

Eigen::VectorXd gap(const ClosedCurves& curves, int upper) {
  return curves.curve(upper).col(1) - curves.curve(upper + 1).col(1);
}

}  // namespace

TEST_F(GenericFaceAnimation, EachFapMovesItsFeaturePointExactly) {
  for (int fap : paperSubset())
    for (double value : {-200.0, -50.0, 50.0, 200.0, 300.0}) {
      FAPFrame frame;
      frame.setValue(fap, value);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      EXPECT_NEAR(shift.norm(), std::abs(value) * animator.units().perValue(fapDefinition(fap).unit), 1e-9)
          << "FAP " << fap << " = " << value;
    }
}

TEST_F(GenericFaceAnimation, LipsAndLidsNeverCross) {
  const Eigen::MatrixXd columns = fineColumns(face.curves.pointsPerCurve);
  std::mt19937 random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    std::uniform_real_distribution<double> values(trial % 2 ? -600.0 : -1000.0, trial % 2 ? 600.0 : 1000.0);
    FAPFrame frame;
    for (int fap : paperSubset()) frame.setValue(fap, values(random));
    FaceCurves moved = face;
    moved.curves = animator.animate(frame);
    ASSERT_EQ(describeFault(moved), "");
    for (int upper : {8, FaceLayout::upperLip}) {
      ASSERT_GE(gap(moved.curves, upper).minCoeff(), 0.0);
      ASSERT_GE((columns * gap(moved.curves, upper)).minCoeff(), -0.1);
    }
  }
}

TEST_F(GenericFaceAnimation, OneIrisDiameterClosesTheEye) {
  FAPFrame frame;
  frame.setValue(19, 1024.0);
  const Eigen::VectorXd left = gap(animator.animate(frame), 8), neutral = gap(face.curves, 8);
  const int k = face.curves.pointsPerCurve;
  const double inner = face.feature("3.11")->v * k / (2 * M_PI), outer = face.feature("3.7")->v * k / (2 * M_PI);
  for (int j = static_cast<int>(std::ceil(inner)); j <= outer; ++j) EXPECT_LT(left[j], 0.2) << j;
  for (int j = 1; j < k / 2; ++j) EXPECT_NEAR(left[j], neutral[j], 0.02) << j;
}

TEST_F(GenericFaceAnimation, ExpressionsNeedNoLargeContactAndKeepTheirMovement) {
  for (const ExpressionProfile& expression : defaultExpressions().expressions()) {
    FAPFrame frame;
    defaultExpressions().add(expression.name, 1.0, frame);
    const ClosedCurves& moved = animator.animate(frame);
    EXPECT_EQ(animator.keptShare(), 1.0) << expression.name;
    EXPECT_GT((moved.points - face.curves.points).rowwise().norm().maxCoeff(), 3.0) << expression.name;
  }
}
