#include <gtest/gtest.h>

#include "DataFile.h"
#include "FaceAnimator.h"
#include "SyntheticFace.h"

using namespace mien;

TEST(Followers, OfTheBrowsFadeSmoothlyByTheirHeight) {
  AnimationTable table;
  ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  const FaceCurves face = SyntheticFace::make();
  FaceAnimator animator;
  ASSERT_EQ(animator.bind(face, table), "");
  const auto weights = [&](const char* curve) { return animator.basis().weights(31, FaceLayout::curveIndex(curve)); };
  const auto height = [&](const char* curve, int j) { return face.curves.curve(FaceLayout::curveIndex(curve))(j, 1); };
  const Eigen::VectorXd moved = weights("C6");
  int checked = 0;
  for (const auto& [curve, resting] : {std::pair{"C3", "C1"}, {"C5", "C1"}, {"C7", "C9"}, {"C8", "C9"}})
    for (int j = 0; j < moved.size(); ++j) {
      const double rest = height(resting, j), share = (height(curve, j) - rest) / (height("C6", j) - rest);
      EXPECT_NEAR(weights(curve)[j], moved[j] * (3 * share * share - 2 * share * share * share), 1e-12) << curve;
      checked += moved[j] > 0.0;
    }
  EXPECT_GT(checked, 8);
}
