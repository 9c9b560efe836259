#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "FAPSequence.h"

using namespace mien;

namespace {

FAPSequence ramp(std::size_t count, double framesPerSecond) {
  FAPSequence sequence;
  sequence.framesPerSecond = framesPerSecond;
  sequence.frames.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    sequence.frames[i].number = 1.0 + i;
    sequence.frames[i].setValue(53, 100.0 * i);
  }
  return sequence;
}

}  // namespace

TEST(FAPSequence, EveryTimeStepFindsItsFrameAlsoWhenSummedUp) {
  for (double rate : {2.0, 10.0, 25.0, 29.97, 1000.0 / 33.0}) {
    const FAPSequence sequence = ramp(1000, rate);
    double sum = 0.0;
    for (std::size_t i = 0; i < 1000; ++i, sum += 1.0 / rate) {
      ASSERT_EQ(sequence.indexAtTime(sequence.timeOfFrame(i)), i) << rate;
      ASSERT_EQ(sequence.indexAtTime(sum), i) << rate;
      ASSERT_EQ(sequence.frameAtTime(sequence.timeOfFrame(i), true).value(53), 100.0 * i) << rate;
    }
  }
}

TEST(FAPSequence, TimesOutsideGiveTheEnds) {
  const FAPSequence sequence = ramp(4, 10.0);
  EXPECT_EQ(sequence.indexAtTime(-1.0), 0u);
  EXPECT_EQ(sequence.indexAtTime(1e300), 3u);
  EXPECT_EQ(sequence.indexAtTime(std::numeric_limits<double>::infinity()), 3u);
  EXPECT_EQ(sequence.indexAtTime(std::nan("")), 0u);
  EXPECT_EQ(sequence.frameAtTime(9.0, true).value(53), 300.0);
  EXPECT_EQ(sequence.frameAtTime(-9.0, true).value(53), 0.0);
  EXPECT_DOUBLE_EQ(sequence.duration(), 0.3);
}

TEST(FAPSequence, BetweenFramesTheFrameBeforeOrTheLinearMixture) {
  const FAPSequence sequence = ramp(4, 10.0);
  EXPECT_EQ(sequence.frameAtTime(0.125, false).value(53), 100.0);
  EXPECT_NEAR(sequence.frameAtTime(0.125, true).value(53), 125.0, 1e-10);
  EXPECT_NEAR(sequence.frameAtTime(0.125, true).number, 2.25, 1e-12);
}

TEST(FAPSequence, VisemesAndExpressionsMixByTheirWeights) {
  FAPSequence sequence = ramp(2, 1.0);
  sequence.frames[0].viseme = {10, 0, 63, 0};
  sequence.frames[1].viseme = {14, 0, 63, 0};
  sequence.frames[1].expression = {1, 40, 0, 0, 0, 0};
  const FAPFrame quarter = sequence.frameAtTime(0.25, true);
  EXPECT_EQ(quarter.viseme.select1, 10.0);
  EXPECT_EQ(quarter.viseme.select2, 14.0);
  EXPECT_EQ(quarter.viseme.blend, 0.75 * 63.0);
  EXPECT_EQ(quarter.expression.select1, 1.0);
  EXPECT_EQ(quarter.expression.intensity1, 10.0);
  sequence.frames[0].viseme = {0, 0, 0, 0};  // nothing grows into one
  const FAPFrame grown = sequence.frameAtTime(0.25, true);
  EXPECT_EQ(grown.viseme.select1, 14.0);
  EXPECT_EQ(grown.viseme.select2, 0.0);
  EXPECT_EQ(grown.viseme.blend, 0.25 * 63.0);
}

TEST(FAPSequence, BetweenFramesWithoutVisemesThereIsNone) {
  FAPSequence sequence = ramp(2, 1.0);
  sequence.frames[0] = sequence.frameAtTime(0.5, true);
  EXPECT_EQ(sequence.frames[0].viseme.blend, 0.0);
  EXPECT_EQ(sequence.fapsUsed(), std::vector<int>{53});
}

/// The same pair the other way round is the same face.
TEST(FAPSequence, WeightsBelongToWhatIsSelectedAndNotToItsPlace) {
  FAPSequence sequence = ramp(2, 1.0);
  sequence.frames[0].viseme = {5, 6, 21, 0};
  sequence.frames[1].viseme = {6, 5, 42, 0};
  sequence.frames[0].expression = {1, 10, 2, 20, 0, 0};
  sequence.frames[1].expression = {2, 40, 1, 30, 0, 0};
  const FAPFrame half = sequence.frameAtTime(0.5, true);
  EXPECT_EQ(half.viseme.select1, 5.0);
  EXPECT_EQ(half.viseme.blend, 21.0);
  EXPECT_EQ(half.expression.intensity1, 20.0);
  EXPECT_EQ(half.expression.intensity2, 30.0);
}

TEST(FAPSequence, MoreThanAFrameHasRoomForStaysThatOfTheFrameBefore) {
  FAPSequence sequence = ramp(2, 1.0);
  sequence.frames[0].expression = {1, 10, 2, 20, 0, 0};
  sequence.frames[1].expression = {1, 30, 3, 60, 0, 0};
  sequence.frames[0].viseme = {5, 0, 63, 0};
  sequence.frames[1].viseme = {6, 0, 63, 1};  // and one that only defines
  const FAPFrame frame = sequence.frameAtTime(0.5, true);
  EXPECT_EQ(frame.expression.intensity1, 10.0);
  EXPECT_EQ(frame.expression.select2, 2.0);
  EXPECT_EQ(frame.expression.intensity2, 20.0);
  EXPECT_EQ(frame.viseme.select1, 5.0);
  EXPECT_EQ(frame.viseme.blend, 63.0);
}

TEST(FAPSequence, FindsAFrameByTheNumberWritten) {
  const FAPSequence sequence = ramp(4, 10.0);
  EXPECT_EQ(sequence.indexOfNumber(3.0), std::optional<std::size_t>(2));
  EXPECT_FALSE(sequence.indexOfNumber(0.0).has_value());
}

TEST(FAPSequence, UsedFAPsComeFromTheMasksAndTheValues) {
  FAPSequence sequence = ramp(2, 10.0);
  sequence.frames[1].viseme.select1 = 3;
  EXPECT_EQ(sequence.fapsUsed(), (std::vector<int>{1, 53}));
  sequence.masks.resize(2);
  sequence.masks[0].set(18);
  EXPECT_EQ(sequence.fapsUsed(), (std::vector<int>{1, 19, 53}));
  for (const int fap : sequence.fapsMoved()) {
    bool moved = fap < FAPFrame::firstLowLevel;
    for (const FAPFrame& frame : sequence.frames) moved = moved || frame.value(fap) != 0.0;
    EXPECT_TRUE(moved) << fap;
  }
}
