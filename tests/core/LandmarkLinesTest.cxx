#include <gtest/gtest.h>

#include "LandmarkLines.h"
#include "SyntheticFace.h"

TEST(LandmarkLines, LieOnTheCurvesBetweenTheFeatures) {
  const mien::FaceCurves face = SyntheticFace::make();
  const auto lines = mien::landmarkLines(face);
  ASSERT_EQ(lines.size(), 5u) << "brows, nose and lips: this face has no corners of eyes";
  const mien::FeaturePoint *inner = face.feature("4.1"), *outer = face.feature("4.5");
  EXPECT_LT((lines[0].row(0).transpose() - face.curves.at(inner->curve, inner->v)).norm(), 1e-9);
  EXPECT_LT((lines[0].bottomRows(1).transpose() - face.curves.at(inner->curve, outer->v)).norm(), 1e-9);
  EXPECT_TRUE(mien::landmarkLines(mien::FaceCurves()).empty());
}
