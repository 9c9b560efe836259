#include <gtest/gtest.h>

#include "DataFile.h"
#include "FAPTable.h"
#include "HighLevelFAPs.h"

using namespace mien;

namespace {

class HighLevelFAPs : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(visemes.parse(readDataFile("animation/visemes.json")), "");
    ASSERT_EQ(expressions.parse(readDataFile("animation/expressions.json")), "");
  }

  FAPFrame resolved(FAPFrame frame) const {
    resolveHighLevelFAPs(visemes, expressions, frame);
    return frame;
  }

  static double shape(const ExpressionLibrary& library, int select, int fap) {
    FAPFrame frame;
    if (select > 0) library.add(library.find(select)->name, 1.0, frame);
    return frame.value(fap);
  }

  ExpressionLibrary visemes, expressions;
};

}  // namespace

TEST_F(HighLevelFAPs, EveryVisemeIsThereAndSymmetric) {
  ASSERT_EQ(visemes.expressions().size(), 14u);
  for (int select = 1; select <= 14; ++select) {
    ASSERT_NE(visemes.find(select), nullptr) << select;
    FAPFrame frame;
    visemes.add(visemes.find(select)->name, 1.0, frame);
    EXPECT_FALSE(frame.isNeutral()) << select;
    for (int fap = 3; fap <= FAPFrame::count; ++fap) EXPECT_EQ(mirrored(frame).value(fap), frame.value(fap)) << select;
  }
}

TEST_F(HighLevelFAPs, VisemesBlendAsTheStandardHasIt) {
  for (int first = 0; first <= 14; ++first)
    for (double blend : {0.0, 21.0, 63.0}) {
      FAPFrame frame;
      const int second = 14 - first;
      frame.viseme.select1 = first;
      frame.viseme.select2 = second;
      frame.viseme.blend = blend;
      frame.setValue(52, 7.0);
      const FAPFrame result = resolved(frame);
      for (int fap = 3; fap <= FAPFrame::count; ++fap)
        EXPECT_NEAR(result.value(fap),
                    frame.value(fap) + shape(visemes, first, fap) * blend / 63.0 +
                        shape(visemes, second, fap) * (1.0 - blend / 63.0),
                    1e-10);
      EXPECT_EQ(result.viseme.select1, 0.0);
      EXPECT_EQ(result.viseme.select2, 0.0);
    }
}

TEST_F(HighLevelFAPs, ExpressionsMixByTheirIntensities) {
  FAPFrame frame;
  frame.expression.select1 = 1;
  frame.expression.intensity1 = 63;
  frame.expression.select2 = 6;
  frame.expression.intensity2 = 21;
  const FAPFrame result = resolved(frame);
  for (int fap = 3; fap <= FAPFrame::count; ++fap)
    EXPECT_NEAR(result.value(fap), shape(expressions, 1, fap) + shape(expressions, 6, fap) / 3.0, 1e-10);
}

TEST_F(HighLevelFAPs, ADefiningFrameKeepsItsOwnValues) {
  FAPFrame frame;
  frame.viseme.select1 = 10;
  frame.viseme.blend = 63;
  frame.viseme.definition = 1;
  frame.setValue(3, 12.0);
  const FAPFrame result = resolved(frame);
  EXPECT_EQ(result.value(3), 12.0);
  EXPECT_EQ(result.value(52), 0.0);
}

TEST_F(HighLevelFAPs, AnUnknownSelectionStays) {
  FAPFrame frame;
  frame.viseme.select1 = 15;
  frame.viseme.blend = 63;
  EXPECT_EQ(resolved(frame).viseme.select1, 15.0);
}
