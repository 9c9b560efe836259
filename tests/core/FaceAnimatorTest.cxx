#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "DataFile.h"
#include "EntryReach.h"
#include "FAPAxis.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "FineColumns.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

AnimationTable defaultTable() {
  AnimationTable table;
  EXPECT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  return table;
}

class FaceAnimatorTest : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    face = SyntheticFace::make(GetParam());
    table = defaultTable();
    ASSERT_EQ(animator.bind(face, table), "");
  }

  FAPFrame randomFrameOfAll(double range) {
    FAPFrame frame;
    std::uniform_real_distribution<double> values(-range, range);
    for (const AnimationEntry& entry : table.entries()) frame.setValue(entry.fap, values(random));
    return frame;
  }

  FAPFrame randomFrame(double range) {
    FAPFrame frame;
    std::uniform_real_distribution<double> values(-range, range);
    for (int fap : paperSubset()) frame.setValue(fap, values(random));
    return frame;
  }

  double largestSingle(const FAPFrame& frame, std::initializer_list<int> faps) const {
    double largest = 0.0;
    for (int fap : faps)
      largest = std::max(largest, std::abs(frame.value(fap)) * animator.units().perValue(fapDefinition(fap).unit));
    return largest;
  }

  double furthest(const ClosedCurves& moved, std::initializer_list<const char*> curves, double from, double to) const {
    double distance = 0.0;
    const int k = moved.pointsPerCurve;
    for (const char* name : curves)
      for (int j = static_cast<int>(std::ceil(from * k / (2 * M_PI))); j <= to * k / (2 * M_PI); ++j) {
        const int c = FaceLayout::curveIndex(name);
        distance = std::max(distance, (moved.curve(c).row(j) - face.curves.curve(c).row(j)).norm());
      }
    return distance;
  }

  void expectNoCrossing(const ClosedCurves& moved, int upper, int lower, const Eigen::MatrixXd& columns) const {
    const Eigen::VectorXd gap = moved.curve(upper).col(1) - moved.curve(lower).col(1);
    ASSERT_GE(gap.minCoeff(), 0.0);
    ASSERT_GE((columns * gap).minCoeff(), -0.1);
  }

  AnimationTable table;
  FaceCurves face;
  FaceAnimator animator;
  FAPFrame frameOfLips;
  std::mt19937 random{7};
};

}  // namespace

TEST_P(FaceAnimatorTest, ZeroFrameGivesTheNeutralCurvesBitForBit) {
  FAPFrame frame;
  frame.setValue(52, -300.0);
  EXPECT_NE(animator.animate(frame).points, face.curves.points);
  EXPECT_EQ(animator.animate(FAPFrame()).points, face.curves.points);
}

TEST_P(FaceAnimatorTest, EachFapMovesItsFeaturePointExactly) {
  // 600 is 26 mm for brows, nose and cheek bones, further than the way to the lids or the lips: these curves must give
  // way.
  const auto hasRoom = [](int fap, double value) {
    return std::abs(value) < 600.0 || (fap > 36 && fap != 41 && fap != 42 && fap != 63);
  };
  for (int fap : paperSubset())
    for (double value : {100.0, -100.0, 300.0, -300.0, 600.0, -600.0}) {
      if (!hasRoom(fap, value)) continue;
      FAPFrame frame;
      frame.setValue(fap, value);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      const Eigen::Vector3d expected = value * animator.units().perValue(fapDefinition(fap).unit) * fapAxis(fap);
      EXPECT_LT((shift - expected).norm(), 1e-9) << "FAP " << fap << " = " << value;
      EXPECT_EQ(animator.keptShare(), 1.0) << "FAP " << fap << " = " << value;
    }
}

TEST_P(FaceAnimatorTest, EveryFapOfTheTableMovesItsFeaturePointExactly) {
  // The inner end of a brow is 12 mm from the middle of the face, its skin can be pressed to a quarter: 120 are 7.2
  // mm.
  const auto hasRoom = [](int fap, double value) { return (fap != 37 && fap != 38) || value <= 100.0; };
  for (const AnimationEntry& entry : table.entries())
    for (double value : {1.0, 100.0, 200.0, -200.0}) {
      if (!hasRoom(entry.fap, value)) continue;
      FAPFrame frame;
      frame.setValue(entry.fap, value);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(entry.fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      const Eigen::Vector3d expected =
          value * animator.units().perValue(fapDefinition(entry.fap).unit) * fapAxis(entry.fap);
      EXPECT_LT((shift - expected).norm(), 1e-9) << "FAP " << entry.fap << " = " << value;
    }
}

TEST_P(FaceAnimatorTest, AFapMovesNothingOutsideItsEntry) {
  expectNothingMovesOutsideItsEntry(face, table);
}

TEST_P(FaceAnimatorTest, InnerAndOuterLipSetTogetherDoNotMoveTwice) {
  const auto shiftOf = [&](const char* id) -> Eigen::Vector3d {
    const FeaturePoint* feature = face.feature(id);
    return animator.animate(frameOfLips).at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
  };
  // The quarter of one side rings by half a percent at that of the other.
  const double beside = 0.05;
  const double unit = animator.units().perValue(FAPUnit::MouthNoseSeparation);
  for (double value : {-150.0, -60.0}) {
    for (int fap : {51, 52, 55, 56, 57, 58, 4, 5, 8, 9, 10, 11}) frameOfLips.setValue(fap, value);
    for (const char* id : {"8.1", "8.5", "8.6", "2.2", "2.6", "2.7"})
      EXPECT_NEAR(shiftOf(id).y(), -value * unit, beside) << id;
    for (const char* id : {"8.2", "8.7", "8.8", "2.3", "2.8", "2.9"})
      EXPECT_NEAR(shiftOf(id).y(), value * unit, beside) << id;
    // A contour told at least half of what the other would carry to it follows its own set.
    for (int fap : {4, 5, 8, 9, 10, 11}) frameOfLips.setValue(fap, 0.7 * value);
    EXPECT_NEAR(shiftOf("8.1").y(), -value * unit, beside);
    EXPECT_NEAR(shiftOf("2.2").y(), -0.7 * value * unit, beside);
    EXPECT_NEAR(shiftOf("2.8").y(), 0.7 * value * unit, beside);
    for (int fap : {4, 5, 8, 9, 10, 11}) frameOfLips.setValue(fap, 1.5 * value);
    EXPECT_NEAR(shiftOf("8.2").y(), value * unit, beside);
    EXPECT_NEAR(shiftOf("2.3").y(), 1.5 * value * unit, beside);
  }
  frameOfLips = FAPFrame();
  for (int fap : {53, 6}) frameOfLips.setValue(fap, 100.0);
  EXPECT_NEAR(shiftOf("2.4").x(), 100.0 * animator.units().perValue(FAPUnit::MouthWidth), beside);
  EXPECT_NEAR(shiftOf("8.3").x(), 100.0 * animator.units().perValue(FAPUnit::MouthWidth), 0.3);
}

TEST_P(FaceAnimatorTest, AFapThatSetsInMakesNoJump) {
  std::uniform_real_distribution<double> values(-300.0, 300.0);
  for (const AnimationEntry& entry : table.entries())
    for (int trial = 0; trial < 10; ++trial) {
      FAPFrame frame = randomFrameOfAll(200.0);
      frame.setValue(entry.fap, 0.0);
      const ClosedCurves before = animator.animate(frame);
      frame.setValue(entry.fap, 1e-7);
      const ClosedCurves& after = animator.animate(frame);
      // Contact may choose other columns to lift, which is continuous but steep.
      EXPECT_LT((after.points - before.points).rowwise().norm().maxCoeff(), 1e-5) << "FAP " << entry.fap;
    }
}

TEST_P(FaceAnimatorTest, SqueezedBrowsKeepTheirOrder) {
  const int k = GetParam();
  for (double left : {-600.0, -100.0, 0.0, 100.0, 300.0, 1000.0})
    for (double right : {-600.0, 0.0, 100.0, 600.0}) {
      FAPFrame frame;
      frame.setValue(37, left);
      frame.setValue(38, right);
      const ClosedCurves& moved = animator.animate(frame);
      for (int c = FaceLayout::curveIndex("C2"); c <= FaceLayout::curveIndex("C8"); ++c)
        for (int j = k / 4; j < 3 * k / 4; ++j)
          if (face.curves.curve(c)(j + 1, 0) > face.curves.curve(c)(j, 0)) {
            ASSERT_GT(moved.curve(c)(j + 1, 0), moved.curve(c)(j, 0)) << left << " " << right << " curve " << c;
          }
      if (std::max(left, right) >= 300.0) {
        EXPECT_GT(animator.pushed(), 1.0) << left << " " << right;
      }
    }
}

TEST_P(FaceAnimatorTest, RandomFramesOfAllFapsNeverCross) {
  const Eigen::MatrixXd columns = fineColumns(GetParam());
  for (int trial = 0; trial < 500; ++trial) {
    FaceCurves checked = face;
    checked.curves = animator.animate(randomFrameOfAll(600.0));
    expectNoCrossing(checked.curves, FaceLayout::upperLip, FaceLayout::lowerLip, columns);
    expectNoCrossing(checked.curves, 8, 9, columns);
    ASSERT_EQ(describeFault(checked), "");
  }
}

TEST_P(FaceAnimatorTest, CurvesThatGiveWayForLackOfRoomAreTold) {
  for (const auto& [fap, value] : {std::pair{41, 600.0}, {42, 600.0}, {31, -600.0}, {33, -600.0}}) {
    FAPFrame frame;
    frame.setValue(fap, value);
    const ClosedCurves& moved = animator.animate(frame);
    const FeaturePoint* feature = face.feature(std::string(fapDefinition(fap).featurePoint));
    const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
    const double wanted = std::abs(value) * animator.units().perValue(fapDefinition(fap).unit);
    // samples are pushed, and between them the curve can miss its way by a little more
    EXPECT_GE(animator.pushed(), 0.8 * (wanted - shift.norm())) << "FAP " << fap;
    EXPECT_GT(animator.pushed(), 1.0) << "FAP " << fap;
    frame.setValue(fap, 0.05 * value);
    animator.animate(frame);
    EXPECT_EQ(animator.pushed(), 0.0) << "FAP " << fap;
  }
  FAPFrame absurd;
  absurd.setValue(41, 1e5);
  animator.animate(absurd);
  animator.animate(FAPFrame());
  EXPECT_EQ(animator.pushed(), 0.0);
  EXPECT_EQ(animator.keptShare(), 1.0);
}

TEST_P(FaceAnimatorTest, MirroredFapsGiveMirroredCurves) {
  const int k = GetParam();
  for (int trial = 0; trial < 50; ++trial) {
    const FAPFrame frame = trial % 2 == 0 ? randomFrame(400.0) : randomFrameOfAll(400.0);
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

TEST_P(FaceAnimatorTest, BrowAndLipWeightsAreStaggered) {
  const auto check = [&](std::initializer_list<int> faps, const char* curve) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(GetParam());
    for (int fap : faps) {
      const Eigen::VectorXd weights = animator.basis().weights(fap, FaceLayout::curveIndex(curve));
      EXPECT_GE(weights.minCoeff(), 0.0) << fap << " on " << curve;
      sum += weights;
    }
    EXPECT_LE(sum.maxCoeff(), 1.0 + 1e-12) << curve;
    EXPECT_GT(sum.maxCoeff(), 0.0) << curve;
  };
  for (const char* curve : {"C2", "C5", "C6", "C7", "C8"}) check({31, 32, 33, 34, 35, 36}, curve);
  for (const char* curve : {"C19", "C20", "C21", "C22", "C22'", "C23", "C24", "C25", "C26"}) {
    check({51, 59, 60}, curve);
    check({52, 59, 60}, curve);
    check({53, 54}, curve);
  }
}

TEST_P(FaceAnimatorTest, RandomFramesStayWithinTheLargestSingleDisplacementAndNeverCross) {
  const Eigen::MatrixXd columns = fineColumns(GetParam());
  const double mouth = face.feature("8.3")->v;
  for (int trial = 0; trial < 1500; ++trial) {
    const FAPFrame frame = randomFrame(trial % 2 == 0 ? 600.0 : 1000.0);
    const ClosedCurves& moved = animator.animate(frame);
    ASSERT_LE(furthest(moved, {"C6"}, 0.0, 2 * M_PI - 0.2), largestSingle(frame, {31, 32, 33, 34, 35, 36}) + 1e-9);
    ASSERT_LE(furthest(moved, {"C21", "C22", "C22'", "C23"}, 2 * M_PI - mouth, mouth),
              largestSingle(frame, {51, 52, 53, 54, 59, 60}) + 1e-9)
        << trial;
    expectNoCrossing(moved, FaceLayout::upperLip, FaceLayout::lowerLip, columns);
    expectNoCrossing(moved, 8, 9, columns);
    FaceCurves checked = face;
    checked.curves = moved;
    ASSERT_EQ(describeFault(checked), "");
  }
}

TEST_P(FaceAnimatorTest, OneIrisDiameterClosesTheEye) {
  FAPFrame frame;
  frame.setValue(19, 1024.0);
  const ClosedCurves& moved = animator.animate(frame);
  const int k = GetParam();
  double open = 0.0, otherOpen = 0.0;
  for (int j = 0; j < k; ++j) {
    const double x = face.curves.curve(8)(j, 0), gap = moved.curve(8)(j, 1) - moved.curve(9)(j, 1);
    if (j > k / 2 && x > 18.0 && x < 45.0 && moved.curve(8)(j, 2) > 0.0) open = std::max(open, gap);
    if (x < -18.0 && x > -45.0 && moved.curve(8)(j, 2) > 0.0) otherOpen = std::max(otherOpen, gap);
  }
  EXPECT_LT(open, 0.2);  // samples are lifted a little so that the lids do not cross between them
  EXPECT_GT(otherOpen, 7.0);
}

TEST_P(FaceAnimatorTest, LipsCoincideUnlessTheyPart) {
  for (double value : {300.0, -300.0}) {
    FAPFrame frame;
    for (int fap : {53, 54, 59, 60}) frame.setValue(fap, value);
    const ClosedCurves& moved = animator.animate(frame);
    EXPECT_EQ(moved.curve(FaceLayout::upperLip), moved.curve(FaceLayout::lowerLip));
  }
  FAPFrame frame;
  frame.setValue(52, -500.0);
  const ClosedCurves& moved = animator.animate(frame);
  const double corner = face.feature("2.4")->v;
  double widest = 0.0;
  for (int j = 0; j < GetParam(); ++j) {
    const double gap = moved.curve(FaceLayout::upperLip)(j, 1) - moved.curve(FaceLayout::lowerLip)(j, 1);
    widest = std::max(widest, gap);
    if (std::abs(2 * M_PI * j / GetParam() - M_PI) > corner - M_PI) {
      EXPECT_EQ(gap, 0.0) << j;
    }
  }
  EXPECT_NEAR(widest, 500.0 * animator.units().perValue(FAPUnit::MouthNoseSeparation), 0.05 * widest);
}

TEST_P(FaceAnimatorTest, PressedLipsMeetAndSaySo) {
  FAPFrame frame;
  frame.setValue(51, 200.0);
  frame.setValue(52, 100.0);
  const ClosedCurves& moved = animator.animate(frame);
  EXPECT_EQ(moved.curve(FaceLayout::upperLip).col(1), moved.curve(FaceLayout::lowerLip).col(1));
  EXPECT_NEAR(animator.contactClamped(), 300.0 * animator.units().perValue(FAPUnit::MouthNoseSeparation), 1e-6);
  EXPECT_GT(animator.contactSamples(), 3);
  animator.animate(FAPFrame());
  EXPECT_EQ(animator.contactClamped(), 0.0);
}

TEST_P(FaceAnimatorTest, FapsWithoutAnEntryAreTold) {
  FAPFrame frame;
  frame.setValue(31, 10.0);
  frame.setValue(43, 10.0);
  frame.viseme.select1 = 4.0;
  EXPECT_EQ(animator.ignoredFAPs(frame), (std::vector<int>{1, 43}));
}

TEST_P(FaceAnimatorTest, AbsurdValuesKeepTheCurvesInOrder) {
  for (int fap : paperSubset())
    for (double value : {1e4, -1e4, 1e300, -1e300}) {
      FAPFrame frame;
      frame.setValue(fap, value);
      FaceCurves checked = face;
      checked.curves = animator.animate(frame);
      EXPECT_EQ(describeFault(checked), "") << "FAP " << fap << " = " << value;
    }
}

TEST_P(FaceAnimatorTest, TheExampleOfATableEvaluatesAsPrinted) {
  ASSERT_EQ(table.parse(R"({"format": "mien animation table", "version": 2, "faps": [{"fap": 6,
    "borders": [-1000, 0, 500, 1000], "parts": [{"curves": ["C22", "C22'"], "slopes": [[1, 0, 0], [0.9, 0, 0], [1.5, 0, 4]],
    "profile": {"shape": "sinusoid", "knots": [["8.1", 0], ["2.4", 1], ["8.3+60", 0]]}}]}]})"),
            "");
  ASSERT_EQ(animator.bind(face, table), "");
  const FeaturePoint* feature = face.feature("2.4");
  const double unit = animator.units().perValue(FAPUnit::MouthWidth);
  for (const auto& [value, x, z] : {std::tuple{300.0, 270.0, 0.0}, {600.0, 600.0, 400.0}, {-200.0, -200.0, 0.0}}) {
    FAPFrame frame;
    frame.setValue(6, value);
    const Eigen::Vector3d shift =
        animator.animate(frame).at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
    EXPECT_LT((shift - unit * Eigen::Vector3d(x, 0.0, z)).norm(), 1e-9) << value;
  }
}

INSTANTIATE_TEST_SUITE_P(PointsPerCurve, FaceAnimatorTest, testing::Values(32, 40, 64));

TEST(FaceAnimator, NamesWhatAFaceLacks) {
  FaceAnimator animator;
  FaceCurves face = SyntheticFace::make();
  face.features.erase(face.features.begin());
  EXPECT_NE(animator.bind(face, defaultTable()).find("FAP 31: the face has no feature point 4.1"), std::string::npos);
  EXPECT_NE(animator.bind(SyntheticFace::make(30), defaultTable()).find("at least 32"), std::string::npos);
}
