#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "DataFile.h"
#include "FAPAxis.h"
#include "FAPTable.h"
#include "FaceAnimator.h"
#include "SyntheticFace.h"

using namespace mien;

namespace {

void place(FaceCurves& face, const std::string& id, double v) {
  for (FeaturePoint& feature : face.features)
    if (feature.id == id) feature.v = v;
}

/// Feature points of the brows, from the middle of the face outwards, at random distances of 0.2 to 3 samples; those of
/// the lips moved by up to half a sample; mirrored.
void scatter(FaceCurves& face, std::mt19937& random) {
  const double sample = 2.0 * M_PI / face.curves.pointsPerCurve;
  std::uniform_real_distribution<double> gap(0.2, 3.0), shift(-0.5, 0.5);
  double v = M_PI;
  const auto pair = [&](const char* left, const char* right, double to) {
    place(face, left, to);
    place(face, right, 2.0 * M_PI - to);
  };
  for (const auto& [left, right] : {std::pair{"4.1", "4.2"}, {"4.3", "4.4"}, {"4.5", "4.6"}})
    pair(left, right, v += gap(random) * sample);
  for (const auto& [left, right] : {std::pair{"2.6", "2.7"}, {"2.8", "2.9"}, {"2.4", "2.5"}, {"8.3", "8.4"}})
    pair(left, right, face.feature(left)->v + shift(random) * sample);
  const double corner = std::max(face.feature("8.3")->v, face.feature("2.4")->v + 0.1 * sample);
  pair("8.3", "8.4", corner);
}

}  // namespace

/// Heads that are scanned have their feature points anywhere between the samples, and some of them close together.
TEST(ScatteredFeatures, AreAllMetExactly) {
  AnimationTable table;
  ASSERT_EQ(table.parse(readDataFile("animation/animation_table.json")), "");
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    FaceCurves face = SyntheticFace::make(40);
    scatter(face, random);
    FaceAnimator animator;
    ASSERT_EQ(animator.bind(face, table), "") << "face " << i;
    for (const AnimationEntry& entry : table.entries()) {
      FAPFrame frame;
      frame.setValue(entry.fap, 1.0);
      const ClosedCurves& moved = animator.animate(frame);
      const FeaturePoint* feature = face.feature(std::string(fapDefinition(entry.fap).featurePoint));
      const Eigen::Vector3d shift = moved.at(feature->curve, feature->v) - face.curves.at(feature->curve, feature->v);
      const Eigen::Vector3d expected = animator.units().perValue(fapDefinition(entry.fap).unit) * fapAxis(entry.fap);
      EXPECT_LT((shift - expected).norm(), 1e-9) << "face " << i << ", FAP " << entry.fap;
    }
  }
}
