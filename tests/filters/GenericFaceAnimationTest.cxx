#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "AnimationData.h"
#include "BoundaryCurveData.h"
#include "EntryReach.h"
#include "FAPAxis.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "FineColumns.h"
#include "FoldedCells.h"
#include "vtkBoundaryCurveReader.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

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

  /// In the spline scheme at 224 x 160, z > 50 mm.
  int foldedCells(const FAPFrame& frame) {
    FaceCurves moved = face;
    moved.curves = animator.animate(frame);
    FaceSurfaceOptions options;
    options.scheme = "spline";
    return FoldedCells(FaceSample(moved, options, 224, 160)).count();
  }

  FaceCurves face;
  FaceAnimator animator;
};

/// The largest single displacement of some FAPs, mm.
double largestSingle(const FAPFrame& frame, const FAPUnits& units, std::initializer_list<int> faps) {
  double largest = 0.0;
  for (int fap : faps)
    largest = std::max(largest, std::abs(frame.value(fap)) * units.perValue(fapDefinition(fap).unit));
  return largest;
}

Eigen::VectorXd gap(const ClosedCurves& curves, int upper) {
  return curves.curve(upper).col(1) - curves.curve(upper + 1).col(1);
}

}  // namespace

TEST_F(GenericFaceAnimation, AFapMovesNothingOutsideItsEntry) {
  AnimationTable table;
  ASSERT_EQ(readAnimationTable("", table), "");
  expectNothingMovesOutsideItsEntry(face, table);
}

TEST_F(GenericFaceAnimation, AZeroFrameGivesTheNeutralCurvesBitForBit) {
  FAPFrame frame;
  frame.setValue(52, -300.0);
  EXPECT_NE(animator.animate(frame).points, face.curves.points);
  EXPECT_EQ(animator.animate(FAPFrame()).points, face.curves.points);
}

TEST_F(GenericFaceAnimation, EachFapMovesItsFeaturePointExactly) {
  for (int fap : paperSubset())
    for (double value : {-300.0, -200.0, -50.0, 50.0, 200.0, 300.0}) {
      FAPFrame frame;
      frame.setValue(fap, value);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      const Eigen::Vector3d expected = value * animator.units().perValue(fapDefinition(fap).unit) * fapAxis(fap);
      EXPECT_LT((shift - expected).norm(), 1e-9) << "FAP " << fap << " = " << value;
    }
}

TEST_F(GenericFaceAnimation, MirroredFapsGiveMirroredCurves) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> values(-400.0, 400.0);
  const int k = face.curves.pointsPerCurve;
  for (int trial = 0; trial < 50; ++trial) {
    FAPFrame frame;
    for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
      if (animator.basis().motion(fap)) frame.setValue(fap, values(random));
    const ClosedCurves moved = animator.animate(frame);
    const ClosedCurves& other = animator.animate(mirrored(frame));
    double largest = 0.0;
    for (int c = 0; c < moved.count; ++c)
      for (int j = 0; j < k; ++j) {
        const Eigen::RowVector3d p = moved.curve(c).row(j), q = other.curve(c).row((k - j) % k);
        largest = std::max(largest, (p - Eigen::RowVector3d(-q.x(), q.y(), q.z())).norm());
      }
    EXPECT_LT(largest, 1e-8);
  }
}

TEST_F(GenericFaceAnimation, BrowAndLipWeightsAreNotNegativeAndSumToAtMostOne) {
  const auto check = [&](std::initializer_list<int> faps, const char* curve) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(face.curves.pointsPerCurve);
    for (int fap : faps) {
      const Eigen::VectorXd weights = animator.basis().weights(fap, FaceLayout::curveIndex(curve));
      EXPECT_GE(weights.minCoeff(), 0.0) << fap << " on " << curve;
      sum += weights;
    }
    EXPECT_LE(sum.maxCoeff(), 1.0 + 1e-12) << curve;
    EXPECT_GT(sum.maxCoeff(), 0.0) << curve;
  };
  for (const char* curve : {"C2", "C5", "C6", "C7", "C8"}) check({31, 32, 33, 34, 35, 36}, curve);
  for (const char* curve : {"C20", "C21", "C22", "C22'", "C23", "C24"}) {
    check({51, 59, 60}, curve);
    check({52, 59, 60}, curve);
    check({53, 54}, curve);
  }
}

TEST_F(GenericFaceAnimation, RandomFramesStayBoundedAndNeverCross) {
  const Eigen::MatrixXd columns = fineColumns(face.curves.pointsPerCurve);
  std::mt19937 random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    std::uniform_real_distribution<double> values(trial % 2 ? -600.0 : -1000.0, trial % 2 ? 600.0 : 1000.0);
    FAPFrame frame;
    for (int fap : paperSubset()) frame.setValue(fap, values(random));
    FaceCurves moved = face;
    moved.curves = animator.animate(frame);
    ASSERT_EQ(describeFault(moved), "");
    const int k = face.curves.pointsPerCurve;
    const auto furthest = [&](int curve, double from, double to) {
      const auto shift = moved.curves.curve(curve) - face.curves.curve(curve);
      const int first = static_cast<int>(std::ceil(from * k / (2 * M_PI)));
      const int last = static_cast<int>(to * k / (2 * M_PI));
      return shift.middleRows(first, last - first + 1).rowwise().norm().maxCoeff();
    };
    ASSERT_LE(furthest(5, face.feature("4.6")->v, face.feature("4.5")->v),
              largestSingle(frame, animator.units(), {31, 32, 33, 34, 35, 36}) + 1e-9);
    for (int curve = 20; curve <= 23; ++curve)
      ASSERT_LE(furthest(curve, face.feature("8.4")->v, face.feature("8.3")->v),
                largestSingle(frame, animator.units(), {51, 52, 53, 54, 59, 60}) + 1e-9);
    for (int upper : {8, FaceLayout::upperLip}) {
      ASSERT_GE(gap(moved.curves, upper).minCoeff(), 0.0);
      ASSERT_GE((columns * gap(moved.curves, upper)).minCoeff(), -0.1);
    }
  }
}

TEST_F(GenericFaceAnimation, AllFapsOfTheTableAreExactAloneAndNeverCrossTogether) {
  const Eigen::MatrixXd columns = fineColumns(face.curves.pointsPerCurve);
  AnimationTable table;
  ASSERT_EQ(readAnimationTable("", table), "");
  for (const AnimationEntry& entry : table.entries())
    for (double value : {1.0, 100.0, -100.0, -200.0}) {
      FAPFrame frame;
      frame.setValue(entry.fap, value);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(entry.fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      const Eigen::Vector3d expected =
          value * animator.units().perValue(fapDefinition(entry.fap).unit) * fapAxis(entry.fap);
      EXPECT_LT((shift - expected).norm(), 1e-9) << "FAP " << entry.fap << " = " << value;
    }
  std::mt19937 random(5);
  std::uniform_real_distribution<double> values(-600.0, 600.0);
  for (int trial = 0; trial < 1000; ++trial) {
    FAPFrame frame;
    for (const AnimationEntry& entry : table.entries()) frame.setValue(entry.fap, values(random));
    FaceCurves moved = face;
    moved.curves = animator.animate(frame);
    ASSERT_EQ(describeFault(moved), "");
    for (int upper : {8, FaceLayout::upperLip}) {
      ASSERT_GE(gap(moved.curves, upper).minCoeff(), 0.0);
      ASSERT_GE((columns * gap(moved.curves, upper)).minCoeff(), -0.1);
    }
  }
}

TEST_F(GenericFaceAnimation, BrowsAreSqueezedWithoutFolds) {
  const int neutral = foldedCells(FAPFrame());
  for (double right : {0.0, 100.0}) {
    FAPFrame frame;
    frame.setValue(37, 100.0);
    frame.setValue(38, right);
    EXPECT_LE(foldedCells(frame), neutral + 5) << right;
    EXPECT_EQ(animator.pushed(), 0.0);
    frame.setValue(37, -100.0);
    EXPECT_LE(foldedCells(frame), neutral + 5) << right;
  }
}

TEST_F(GenericFaceAnimation, ExpressionsAndVisemesAddNoMoreThanAHandfulOfFoldedCells) {
  const int neutral = foldedCells(FAPFrame());
  for (const ExpressionLibrary* library : {&defaultExpressions(), &defaultVisemes()})
    for (const ExpressionProfile& expression : library->expressions()) {
      FAPFrame frame;
      library->add(expression.name, 1.0, frame);
      EXPECT_LE(foldedCells(frame), neutral + 5) << expression.name;
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

TEST_F(GenericFaceAnimation, ExpressionsMoveTheFaceAndKeepAllOfIt) {
  for (const ExpressionProfile& expression : defaultExpressions().expressions()) {
    FAPFrame frame;
    defaultExpressions().add(expression.name, 1.0, frame);
    const ClosedCurves& moved = animator.animate(frame);
    EXPECT_EQ(animator.keptShare(), 1.0) << expression.name;
    EXPECT_GT((moved.points - face.curves.points).rowwise().norm().maxCoeff(), 3.0) << expression.name;
  }
}
