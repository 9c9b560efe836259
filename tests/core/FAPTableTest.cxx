#include <gtest/gtest.h>

#include "FAPTable.h"

using namespace mien;

TEST(FAPTable, IsInOrderOfTheNumbers) {
  for (int number = 1; number <= FAPFrame::count; ++number) EXPECT_EQ(fapDefinition(number).number, number);
}

TEST(FAPTable, HoldsThe22OfThePaper) {
  const std::vector<int> expected = {19, 20, 31, 32, 33, 34, 35, 36, 39, 40, 41,
                                     42, 51, 52, 53, 54, 59, 60, 61, 62, 63, 64};
  EXPECT_EQ(paperSubset(), expected);
}

TEST(FAPTable, MirrorsAreMutualAndKeepTheUnit) {
  for (const FAPDefinition& fap : fapTable) {
    const FAPDefinition& partner = fapDefinition(fap.mirrorPartner);
    EXPECT_EQ(partner.mirrorPartner, fap.number);
    EXPECT_EQ(partner.mirrorSign, fap.mirrorSign) << fap.number;
    EXPECT_EQ(partner.unit, fap.unit) << fap.number;
    EXPECT_EQ(partner.group, fap.group) << fap.number;
  }
}

/// A sideways motion on the midline turns round in the mirror; between partners left and right are named in the table.
TEST(FAPTable, TheSignOfTheMirrorAgreesWithTheDirection) {
  for (const FAPDefinition& fap : fapTable) {
    const FAPDirection partner = fapDefinition(fap.mirrorPartner).positiveMotion;
    const bool sideways = fap.positiveMotion == FAPDirection::Left || fap.positiveMotion == FAPDirection::Right;
    const bool sameDirection = partner == fap.positiveMotion;
    EXPECT_EQ(fap.mirrorSign, sideways && sameDirection ? -1 : 1) << fap.number;
  }
}

TEST(FAPTable, NamesThePartsTheFaceDoesNotHave) {
  std::vector<int> all;
  for (int number = 0; number <= 70; ++number) all.push_back(number);
  const std::vector<int> expected = {23, 24, 25, 26, 27, 28, 29, 30, 43, 44, 45, 46, 47, 65, 66, 67, 68};
  EXPECT_EQ(fapsWithoutSurface(all), expected);
  EXPECT_TRUE(fapsWithoutSurface(paperSubset()).empty());
}

TEST(FAPTable, UnitsAreThoseOfTheStandard) {
  EXPECT_EQ(symbol(fapDefinition(19).unit), "IRISD");
  EXPECT_EQ(symbol(fapDefinition(39).unit), "ES");
  EXPECT_EQ(symbol(fapDefinition(31).unit), "ENS");
  EXPECT_EQ(symbol(fapDefinition(51).unit), "MNS");
  EXPECT_EQ(symbol(fapDefinition(53).unit), "MW");
  EXPECT_EQ(symbol(fapDefinition(48).unit), "AU");
  EXPECT_EQ(symbol(fapDefinition(1).unit), "");
}

TEST(FAPTable, MirroringTwiceGivesTheFrameBack) {
  FAPFrame frame;
  for (int number = FAPFrame::firstLowLevel; number <= FAPFrame::count; ++number) frame.setValue(number, number * 1.5);
  const FAPFrame once = mirrored(frame);
  EXPECT_EQ(once.value(53), frame.value(54));
  EXPECT_EQ(once.value(64), -frame.value(64));
  const FAPFrame twice = mirrored(once);
  for (int number = FAPFrame::firstLowLevel; number <= FAPFrame::count; ++number)
    EXPECT_EQ(twice.value(number), frame.value(number));
}
