#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "CurveEdit.h"
#include "FaceLayout.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

CurveEdit edit(const char* curve, double v, const Eigen::Vector3d& move, int spread = 1, bool mirrored = false) {
  CurveEdit result;
  result.curve = FaceLayout::curveIndex(curve);
  result.v = v;
  result.move = move;
  result.spread = spread;
  result.mirrored = mirrored;
  return result;
}

FaceCurves edited(const std::vector<CurveEdit>& edits) {
  FaceCurves face = SyntheticFace::make();
  EXPECT_EQ(applyEdits(edits, face), "");
  return face;
}

}  // namespace

TEST(CurveEdit, NoEditChangesNothing) {
  EXPECT_EQ(edited({}).curves.points, SyntheticFace::make().curves.points);
  EXPECT_EQ(edited({edit("C6", 2.0, {0, 0, 0})}).curves.points, SyntheticFace::make().curves.points);
}

TEST(CurveEdit, AnglesInDegreesAndPointsByTheirNumber) {
  CurveEdit quarter = CurveEdit::ofPoint(3, 10, 40);
  EXPECT_EQ(quarter.curve, 3);
  EXPECT_DOUBLE_EQ(quarter.v, M_PI / 2);
  EXPECT_DOUBLE_EQ(quarter.vDegrees(), 90.0);
  quarter.setWidthDegrees(45.0);
  EXPECT_DOUBLE_EQ(quarter.width, M_PI / 4);
  EXPECT_DOUBLE_EQ(quarter.widthDegrees(), 45.0);
}

TEST(CurveEdit, ThePointGoesWhereItIsMovedAndTheRestFallsOff) {
  const FaceCurves before = SyntheticFace::make();
  const double v = 2.0 * M_PI * 23 / 40;
  const Eigen::Vector3d move(0.5, 1.0, -2.0);
  const FaceCurves after = edited({edit("C12", v, move, 2)});
  const ClosedCurves::Points shift = after.curves.points - before.curves.points;
  const int row = 11 * 40 + 23;
  EXPECT_LT((shift.row(row).transpose() - move).norm(), 1e-12);
  EXPECT_GT(shift.row(row + 40).norm(), 0.5 * move.norm());
  EXPECT_LT(shift.row(row + 80).norm(), shift.row(row + 40).norm());
  EXPECT_EQ(shift.row(row + 120).norm(), 0.0) << "two neighbours follow, no more";
  EXPECT_LT(shift.rowwise().norm().maxCoeff(), move.norm() + 1e-12);
  for (int j = 0; j < 40; ++j)
    if (std::abs(j - 23) > 2) {
      EXPECT_EQ(shift.row(11 * 40 + j).norm(), 0.0) << "25 degrees are 2.8 points";
    }
}

TEST(CurveEdit, BetweenSamplesTheInterpolantFollows) {
  const double v = 2.0 * M_PI * 23.5 / 40;
  const int curve = FaceLayout::curveIndex("C12");
  const FaceCurves before = SyntheticFace::make();
  CurveEdit wide = edit("C12", v, {0, 0, 3.0}, 0);
  wide.width = 0.7;
  const FaceCurves after = edited({wide});
  EXPECT_NEAR(after.curves.at(curve, v).z() - before.curves.at(curve, v).z(), 3.0, 0.02);
}

TEST(CurveEdit, MirroredEditsKeepASymmetricFaceSymmetric) {
  for (const double v : {M_PI, M_PI + 0.05, M_PI + 0.2, M_PI + 0.9, 0.0, 5.9}) {
    const FaceCurves face = edited({edit("C14", v, {0.7, 0.3, 1.0}, 2, true)});
    for (int c = 0; c < face.curves.count; ++c)
      for (int j = 1; j < 20; ++j) {
        const Eigen::RowVector3d p = face.curves.curve(c).row(j), q = face.curves.curve(c).row(40 - j);
        const bool onMidline = v == M_PI || v == 0.0;  // moved as asked, x included
        EXPECT_LT(onMidline ? 0.0 : (p - Eigen::RowVector3d(-q.x(), q.y(), q.z())).norm(), 1e-12) << v;
      }
    const ClosedCurves::Points shift = face.curves.points - SyntheticFace::make().curves.points;
    // between the point and its mirror image both add up to (1 + c) / (1 + c^2), at most 1.21
    EXPECT_LT(shift.col(2).cwiseAbs().maxCoeff(), 1.21) << v;
  }
}

TEST(CurveEdit, ClosedLipsStayClosed) {
  const FaceCurves face = edited({edit("C22'", M_PI, {0, 0, 2.0}, 0), edit("C21", M_PI, {0, 0, 1.0}, 3)});
  EXPECT_EQ(face.curves.curve(FaceLayout::upperLip), face.curves.curve(FaceLayout::lowerLip));
}

TEST(CurveEdit, PupilsFollowTheLidsAndFeaturesKeepTheirAddresses) {
  const FaceCurves before = SyntheticFace::make();
  const FeaturePoint* lid = before.feature("3.1");
  const FaceCurves after = edited({edit("C9", lid->v, {0, 0, 2.0}, 3)});
  EXPECT_GT(after.leftPupil.z() - before.leftPupil.z(), 1.0);
  EXPECT_LE(after.leftPupil.z() - before.leftPupil.z(), 2.0);
  EXPECT_LT((after.rightPupil - before.rightPupil).norm(), 0.005) << "only what the interpolant leaves between samples";
  for (size_t i = 0; i < after.features.size(); ++i) EXPECT_EQ(after.features[i].v, before.features[i].v);
}

TEST(CurveEdit, CrossingsAreRefusedAndNamed) {
  FaceCurves face = SyntheticFace::make();
  const FaceCurves before = face;
  const std::string fault = applyEdits({edit("C3", M_PI, {0, 1, 0}), edit("C6", M_PI, {0, 70, 0}, 0)}, face);
  EXPECT_EQ(fault.rfind("edit 2 (C6): ", 0), 0u) << fault;
  EXPECT_NE(fault.find("C5"), std::string::npos) << fault;
  EXPECT_EQ(face.curves.points, before.curves.points);
}

TEST(CurveEdit, ValuesOutOfRangeAreRefused) {
  const double nan = std::nan("");
  CurveEdit sound = edit("C6", 1.0, {0, 1, 0});
  EXPECT_EQ(describeFault(sound, 40), "");
  for (const auto& change : std::vector<std::function<void(CurveEdit&)>>{
           [](CurveEdit& e) { e.curve = 29; }, [](CurveEdit& e) { e.curve = -1; }, [](CurveEdit& e) { e.v = -0.1; },
           [nan](CurveEdit& e) { e.v = nan; }, [nan](CurveEdit& e) { e.move.y() = nan; },
           [](CurveEdit& e) { e.move.x() = 101.0; }, [](CurveEdit& e) { e.width = 0.1; },
           [nan](CurveEdit& e) { e.width = nan; }, [](CurveEdit& e) { e.width = 4.0; },
           [](CurveEdit& e) { e.spread = -1; }, [](CurveEdit& e) { e.spread = 29; }}) {
    CurveEdit wrong = sound;
    change(wrong);
    EXPECT_NE(describeFault(wrong, 40), "");
  }
}
