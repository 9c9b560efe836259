#include <Eigen/Geometry>

#include "RegionMap.h"
#include "TableRecognition.h"

using namespace mien;

namespace {

/// Lips and chin move by `down`, brows by `up`.
DeformationTable expression(double up, double down) {
  DeformationTable table;
  for (const int region : {1, 2, 4, 5}) table.maps[region - 1].coefficients(1, 5) = up;
  for (const int region : {13, 16}) table.maps[region - 1].coefficients(1, 5) = -down;
  return table;
}

}  // namespace

TEST(TableRecognition, TheNearestMeanComesFirstAndItselfAtNoDistance) {
  const FacialRegions regions = regionMap();
  const std::vector<DeformationTable> means = {expression(0.1, 0.0), expression(0.0, 0.3), expression(-0.1, 0.0)};
  std::vector<RecognitionScore> scores;
  ASSERT_EQ(recognise(means[1], regions, means, scores), "");
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_EQ(scores[0].expression, 1);
  EXPECT_NEAR(scores[0].distance, 0.0, 1e-14);
  EXPECT_NEAR(scores[0].intensity, 1.0, 1e-14);
  EXPECT_LT(scores[0].distance, scores[1].distance);
  const std::vector<int> decisive = decisiveRegions(scores, 2);
  EXPECT_EQ((std::vector<int>{std::min(decisive[0], decisive[1]), std::max(decisive[0], decisive[1])}),
            (std::vector<int>{13, 16}));
}

TEST(TableRecognition, IntensityAndHeadMovementDoNotMatter) {
  const FacialRegions regions = regionMap();
  const std::vector<DeformationTable> means = {expression(0.1, 0.0), expression(0.0, 0.3)};
  DeformationTable shown = expression(0.0, 0.18);
  const Eigen::Matrix2d turn = 1.02 * Eigen::Rotation2Dd(0.03).toRotationMatrix();
  for (QuadraticMap& map : shown.maps) {
    map.coefficients = turn * map.coefficients;
    map.coefficients(0, 5) += 0.04;
  }
  std::vector<RecognitionScore> scores;
  ASSERT_EQ(recognise(shown, regions, means, scores), "");
  EXPECT_EQ(scores[0].expression, 1);
  EXPECT_NEAR(scores[0].intensity, 0.6, 0.03);
  EXPECT_LT(scores[0].distance, 0.01);
}

TEST(TableRecognition, RegionsThatAreNotKnownDoNotCount) {
  const FacialRegions regions = regionMap();
  const std::vector<DeformationTable> means = {expression(0.1, 0.3), expression(0.0, 0.3), expression(0.1, 0.0)};
  DeformationTable shown = means[0];
  shown.counts.emplace().fill(1);
  for (const int region : {1, 2, 4, 5}) {
    shown.counts->at(region - 1) = 0;
    shown.maps[region - 1] = QuadraticMap();
  }
  std::vector<RecognitionScore> scores;
  ASSERT_EQ(recognise(shown, regions, means, scores), "");
  EXPECT_NEAR(scores[0].distance, 0.0, 1e-14);
  EXPECT_NEAR(scores[1].distance, 0.0, 1e-14) << "the brows, which tell the two apart, were not seen";
  EXPECT_EQ(scores[2].expression, 2);
  EXPECT_EQ(scores[0].regions[0], 0.0);
  shown.counts->fill(0);
  EXPECT_NE(recognise(shown, regions, means, scores).find("no points"), std::string::npos);
  EXPECT_NE(recognise(means[0], regions, {shown}, scores).find("no region"), std::string::npos);
}

TEST(TableRecognition, SaysWhatIsMissing) {
  std::vector<RecognitionScore> scores;
  EXPECT_NE(recognise(DeformationTable(), regionMap(), {}, scores).find("no table"), std::string::npos);
  EXPECT_NE(recognise(TableSamples(), {DeformationTable()}, scores).find("no points"), std::string::npos);
}
