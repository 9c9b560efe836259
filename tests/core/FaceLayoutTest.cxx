#include <gtest/gtest.h>

#include "FaceLayout.h"

using namespace mien;

TEST(FaceLayout, NamesAndIdsFollowTheFileFormat) {
  EXPECT_EQ(FaceLayout::curveName(0), "C1");
  EXPECT_EQ(FaceLayout::curveName(FaceLayout::upperLip), "C22");
  EXPECT_EQ(FaceLayout::curveName(FaceLayout::lowerLip), "C22'");
  EXPECT_EQ(FaceLayout::curveName(28), "C28");
  EXPECT_EQ(FaceLayout::curveId(FaceLayout::lowerLip), 29);
  for (int index = 0; index < FaceLayout::curveCount; ++index)
    EXPECT_EQ(FaceLayout::curveIndex(FaceLayout::curveName(index)), index);
  EXPECT_EQ(FaceLayout::curveIndex("C29"), -1);
}

TEST(FaceLayout, NeighbouringPatchesShareACurveExceptAtTheMouth) {
  for (int p = 0; p + 1 < FaceLayout::patchCount; ++p) {
    const int last = FaceLayout::firstCurve[p] + FaceLayout::curvesPerPatch - 1;
    const int expected = last == FaceLayout::upperLip ? FaceLayout::lowerLip : last;
    EXPECT_EQ(FaceLayout::firstCurve[p + 1], expected);
  }
}
