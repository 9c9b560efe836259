#include <gtest/gtest.h>

#include "FAPUnits.h"
#include "SyntheticFace.h"

using namespace mien;

TEST(FAPUnits, MeasuresTheFace) {
  FAPUnits units;
  ASSERT_EQ(measureFAPUnits(SyntheticFace::make(64), units), "");
  EXPECT_NEAR(units.irisDiameter, 8.0, 0.05);
  EXPECT_NEAR(units.eyeSeparation, 63.0, 1e-12);
  EXPECT_NEAR(units.eyeNoseSeparation, 45.0, 1e-9);
  EXPECT_NEAR(units.mouthNoseSeparation, 20.5, 1e-9);
  EXPECT_NEAR(units.mouthWidth, 52.0, 1e-9);
  EXPECT_NEAR(units.perValue(FAPUnit::MouthWidth), 52.0 / 1024.0, 1e-12);
  EXPECT_EQ(units.perValue(FAPUnit::Angle), 1e-5);
}

TEST(FAPUnits, NamesWhatIsMissing) {
  FAPUnits units;
  FaceCurves face = SyntheticFace::make();
  for (FeaturePoint& feature : face.features)
    if (feature.id == "9.15") feature.id = "9.99";
  EXPECT_NE(measureFAPUnits(face, units).find("9.15"), std::string::npos);
  face = SyntheticFace::make();
  std::swap(face.leftPupil, face.rightPupil);
  EXPECT_NE(measureFAPUnits(face, units).find("ES"), std::string::npos);
  face.hasPupils = false;
  EXPECT_NE(measureFAPUnits(face, units).find("pupils"), std::string::npos);
  EXPECT_EQ(units.eyeSeparation, 0.0);
}
