#include <gtest/gtest.h>

#include "FaceSurface.h"
#include "SharedDerivatives.h"

using namespace mien;

TEST(FaceSurfaceOptions, FaultsSayWhatIsAllowed) {
  FaceSurfaceOptions options;
  EXPECT_EQ(describeFault(options, 40), "");
  options.modes = 21;
  EXPECT_NE(describeFault(options, 40).find("0 .. 20"), std::string::npos);
  options = {};
  options.smoothing[4] = 0.0;
  EXPECT_NE(describeFault(options, 40).find("0 < a <= 1000"), std::string::npos);
  options.smoothing[4] = std::nan("");
  EXPECT_NE(describeFault(options, 40), "");
  options = {};
  options.scheme = "five-curve";
  EXPECT_NE(describeFault(options, 40).find("four-curve"), std::string::npos);
}

TEST(FaceSurfaceOptions, FourCurveBeyondItsLimitIsRefusedAndTheLimitNamed) {
  FaceSurfaceOptions options;
  options.scheme = "four-curve";
  options.smoothing.fill(41.0);
  EXPECT_EQ(describeFault(options, 40), "");
  options.smoothing.fill(42.0);
  EXPECT_NE(describeFault(options, 40).find("a (N + 1) = 250"), std::string::npos);
  options.scheme = "derivative";
  options.smoothing.fill(1000.0);
  EXPECT_EQ(describeFault(options, 40), "");
}

TEST(RowLayout, EveryCurveIsARowWhenRowsAre27kPlus2) {
  for (const int rows : {29, 56, 83, 110}) {
    const RowLayout layout(rows, false);
    EXPECT_EQ(static_cast<int>(layout.rows().size()), rows);
    EXPECT_TRUE(layout.missedCurves().empty()) << rows;
  }
}

TEST(RowLayout, EverySeamIsARowOtherwise) {
  for (int rows = RowLayout::minimumRows; rows < 120; ++rows) {
    const RowLayout layout(rows, false);
    EXPECT_EQ(static_cast<int>(layout.rows().size()), rows);
    for (const std::string& name : layout.missedCurves()) {
      const int curve = FaceLayout::curveIndex(name);
      for (const int first : FaceLayout::firstCurve)
        EXPECT_TRUE(curve != first && curve != first + 3) << name << " at " << rows;
    }
  }
}

TEST(RowLayout, LipsAreTwoRowsAtOnePlace) {
  for (const bool uniform : {false, true})
    for (const int rows : {11, 28, 50, 56, 57}) {
      const RowLayout layout(rows, uniform);
      ASSERT_EQ(static_cast<int>(layout.rows().size()), rows);
      const FaceRow& upper = layout.rows()[layout.upperLipRow()];
      const FaceRow& lower = layout.rows()[layout.upperLipRow() + 1];
      EXPECT_EQ(upper.patch, 6);
      EXPECT_EQ(upper.u, 1.0);
      EXPECT_EQ(lower.patch, 7);
      EXPECT_EQ(lower.u, 0.0);
      EXPECT_EQ(upper.faceU, lower.faceU);
    }
}

TEST(RowLayout, UniformRowsTakeEqualStepsButAtTheLips) {
  const RowLayout layout(56, true);
  for (int i = 0; i < 56; ++i) {
    if (i == layout.upperLipRow() || i == layout.upperLipRow() + 1) continue;
    EXPECT_NEAR(layout.rows()[i].faceU, (i > layout.upperLipRow() ? i - 1 : i) / 54.0, 1e-12);
  }
}

TEST(FacePieces, DealEveryRowOnce) {
  for (const bool uniform : {false, true})
    for (const FaceScheme& scheme : faceSchemes()) {
      FaceSurfaceOptions options;
      options.scheme = scheme.name;
      int next = 0;
      for (const SurfacePiece& piece : facePieces(options, RowLayout(53, uniform))) {
        EXPECT_EQ(piece.firstRow, next);
        next += static_cast<int>(piece.u.size());
      }
      EXPECT_EQ(next, 53);
    }
}

TEST(SharedDerivatives, AreExactForPolynomialsAndTheClosedMouthIsOneChain) {
  Eigen::VectorXd quadratic(FaceLayout::curveCount), slope(FaceLayout::curveCount);
  for (int c = 0; c < FaceLayout::curveCount; ++c) {
    const double u = (c > FaceLayout::upperLip ? c - 1 : c) / 3.0;
    quadratic[c] = 2.0 + u + 0.5 * u * u;
    slope[c] = 1.0 + u;
  }
  const Eigen::VectorXd first = sharedDerivatives(differenceDerivatives, 1, {}) * quadratic,
                        second = sharedDerivatives(differenceDerivatives, 2, {}) * quadratic;
  for (int c = 1; c + 1 < FaceLayout::curveCount; ++c) EXPECT_NEAR(first[c], slope[c], 1e-12);
  for (int c = 0; c < FaceLayout::curveCount; ++c) EXPECT_NEAR(second[c], 1.0, 1e-11);
  EXPECT_EQ(first[FaceLayout::upperLip], first[FaceLayout::lowerLip]);
}

TEST(SharedDerivatives, LipsPartOneSidedly) {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(FaceLayout::curveCount);
  gap[FaceLayout::upperLip] = -1.0;
  gap[FaceLayout::lowerLip] = 1.0;
  const Eigen::VectorXd slope = sharedDerivatives(differenceDerivatives, 1, {}) * gap;
  EXPECT_NEAR(slope[FaceLayout::upperLip], -3.0, 1e-12);
  EXPECT_NEAR(slope[FaceLayout::lowerLip], -3.0, 1e-12);
  EXPECT_NEAR(slope[FaceLayout::upperLip - 1], -1.5, 1e-12);
  EXPECT_NEAR(slope[FaceLayout::lowerLip + 1], -1.5, 1e-12);
}
