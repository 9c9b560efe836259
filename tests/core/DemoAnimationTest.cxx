#include <gtest/gtest.h>

#include "DataFile.h"
#include "FAPParser.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "SyntheticFace.h"

using namespace mien;

TEST(DemoAnimation, Has301FramesOfThePapersFapsBetweenNeutralOnes) {
  FAPSequence sequence;
  ASSERT_FALSE(parseFAP(readDataFile("animation/demo.fap"), sequence));
  EXPECT_TRUE(sequence.warnings.empty());
  EXPECT_EQ(sequence.frames.size(), 301u);
  EXPECT_EQ(sequence.framesPerSecond, 25.0);
  EXPECT_EQ(sequence.fapsUsed(), paperSubset());
  EXPECT_TRUE(sequence.frames.front().isNeutral());
  EXPECT_TRUE(sequence.frames.back().isNeutral());
}

TEST(DemoAnimation, MovesWithoutJumpsAndKeepsTheCurvesInOrder) {
  FAPSequence sequence;
  ASSERT_FALSE(parseFAP(readDataFile("animation/demo.fap"), sequence));
  AnimationTable table;
  ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  FaceAnimator animator;
  ASSERT_EQ(animator.bind(SyntheticFace::make(), table), "");
  ClosedCurves previous = animator.animate(sequence.frames.front());
  double largestStep = 0.0, furthest = 0.0;
  for (const FAPFrame& frame : sequence.frames) {
    const ClosedCurves& curves = animator.animate(frame);
    largestStep = std::max(largestStep, (curves.points - previous.points).rowwise().norm().maxCoeff());
    furthest = std::max(furthest, (curves.points - animator.neutral().curves.points).rowwise().norm().maxCoeff());
    EXPECT_EQ(animator.keptShare(), 1.0) << frame.number;
    previous = curves;
  }
  EXPECT_GT(furthest, 8.0);
  EXPECT_LT(largestStep, 4.0);
}
