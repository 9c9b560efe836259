#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "ReferenceData.h"
#include "RegionMap.h"
#include "TableFit.h"
#include "TableRecognition.h"
#include "TableStatistics.h"
#include "TextFile.h"

using namespace mien;

namespace {

constexpr int subjectCount = 12, expressionCount = 6;
const char* const expressions[] = {"anger", "disgust", "fear", "joy", "sadness", "surprise"};

std::string recordingText(int subject, int expression) {
  const std::string number = (subject < 9 ? "0" : "") + std::to_string(subject + 1);
  return readTextFile(referencePath("markers/subject" + number + "_" + expressions[expression] + ".csv"));
}

std::vector<TableSamples> allSamples(const FacialRegions& regions) {
  std::vector<TableSamples> samples;
  for (int i = 0; i < subjectCount * expressionCount; ++i) {
    MarkerTable markers;
    EXPECT_EQ(markers.parse(recordingText(i / expressionCount, i % expressionCount)), "");
    samples.push_back(samplesOf(markers, regions));
  }
  return samples;
}

TableFit fitted(const TableSamples& samples) {
  TableFit fit;
  EXPECT_EQ(fit.fit(samples), "");
  return fit;
}

/// Recordings (of 72) named rightly against the means over the other subjects.
int recognised(const std::vector<DeformationTable>& clean, const std::vector<TableSamples>& shown) {
  int right = 0;
  for (int subject = 0; subject < subjectCount; ++subject) {
    std::vector<DeformationTable> means;
    for (int expression = 0; expression < expressionCount; ++expression) {
      std::vector<DeformationTable> others;
      for (int other = 0; other < subjectCount; ++other)
        if (other != subject) others.push_back(clean[other * expressionCount + expression]);
      means.push_back(meanTable(others));
    }
    for (int expression = 0; expression < expressionCount; ++expression) {
      std::vector<RecognitionScore> scores;
      EXPECT_EQ(recognise(shown[subject * expressionCount + expression], means, scores), "");
      right += scores.front().expression == expression;
    }
  }
  return right;
}

TableSamples noisy(TableSamples samples, double deviation, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, deviation);
  for (Eigen::Index i = 0; i < samples.after.size(); ++i) samples.after.data()[i] += noise(random);
  return samples;
}

/// The recording as two photographs would give it: pixels, y downwards, no depth.
std::string asPixels(const std::string& text) {
  std::istringstream stream(text);
  std::string line, result = "marker,neutral_x,neutral_y,expression_x,expression_y\n";
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    std::string name, cell;
    std::getline(cells, name, ',');
    double values[6];
    for (double& value : values) std::getline(cells, cell, ','), value = std::stod(cell);
    std::ostringstream row;
    row.precision(17);
    row << name << "," << 800 + 4 * values[0] << "," << 900 - 4 * values[1] << "," << 800 + 4 * values[3] << ","
        << 900 - 4 * values[4] << "\n";
    result += row.str();
  }
  return result;
}

}  // namespace

TEST(FDTReference, QuadraticsFitTheRecordings) {
  MIEN_REQUIRE_REFERENCE("markers");
  const FacialRegions regions = regionMap();
  double sum = 0.0;
  int sparse = 0;
  for (const TableSamples& samples : allSamples(regions)) {
    const TableFit fit = fitted(samples);
    sum += fit.rms / 72;
    sparse += !fit.sparseRegions().empty();
  }
  RecordProperty("mean_rms_1e6", int(1e6 * sum));
  RecordProperty("recordings_with_a_sparse_region", sparse);
  EXPECT_LE(sum, 0.025);
  EXPECT_GT(sum, 0.0);
}

TEST(FDTReference, RecognisesSubjectsItHasNotSeen) {
  MIEN_REQUIRE_REFERENCE("markers");
  std::vector<DeformationTable> tables;
  const std::vector<TableSamples> recordings = allSamples(regionMap());
  for (const TableSamples& samples : recordings) tables.push_back(fitted(samples).table);
  const int right = recognised(tables, recordings);
  RecordProperty("recognised", right);
  EXPECT_GE(right, 70);
}

/// Noise on every marker of both states, and on the pupils when `pupils` is set.
std::vector<TableSamples> noisyRecordings(double deviation, bool pupils, std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, deviation);
  const auto moved = [&](const Eigen::Vector3d& point, double unit) {
    return Eigen::Vector3d(point.x() + unit * noise(random), point.y() + unit * noise(random), point.z());
  };
  std::vector<TableSamples> result;
  const FacialRegions regions = regionMap();
  for (int i = 0; i < subjectCount * expressionCount; ++i) {
    MarkerTable table;
    EXPECT_EQ(table.parse(recordingText(i / expressionCount, i % expressionCount)), "");
    const double before = table.neutral.unit(), after = table.expression.unit();
    for (Marker& marker : table.markers) {
      marker.neutral = moved(marker.neutral, before);
      marker.expression = moved(marker.expression, after);
    }
    for (PupilNormalisation* state : {&table.neutral, &table.expression}) {
      const double unit = pupils ? state->unit() : 0.0;
      const Eigen::Vector3d left = moved(state->invert({1, 0, 0}), unit),
                            right = moved(state->invert({-1, 0, 0}), unit);
      EXPECT_EQ(state->set(left, right), "");
    }
    result.push_back(samplesOf(table, regions));
  }
  return result;
}

TEST(FDTReference, RecognisesThroughNoise) {
  MIEN_REQUIRE_REFERENCE("markers");
  std::vector<DeformationTable> tables;
  const std::vector<TableSamples> recordings = allSamples(regionMap());
  for (const TableSamples& samples : recordings) tables.push_back(fitted(samples).table);
  for (const unsigned seed : {71u, 72u, 73u, 74u, 75u, 76u, 77u, 78u}) {
    std::mt19937 random(seed);
    std::vector<TableSamples> after = recordings;
    for (TableSamples& samples : after) samples = noisy(samples, 0.05, random);
    EXPECT_GE(recognised(tables, after), 68) << "expression, seed " << seed;
    EXPECT_GE(recognised(tables, noisyRecordings(0.05, false, random)), 68) << "both states, seed " << seed;
    EXPECT_GE(recognised(tables, noisyRecordings(0.05, true, random)), 68) << "both states and pupils, seed " << seed;
  }
}

TEST(FDTReference, PixelsGiveTheSameTables) {
  MIEN_REQUIRE_REFERENCE("markers");
  const FacialRegions regions = regionMap();
  MarkerTable space, picture;
  MarkerOptions options;
  const std::string text = recordingText(0, 3);
  ASSERT_EQ(space.parse(text), "");
  EXPECT_NE(picture.parse(asPixels(text)).find("--y-down"), std::string::npos);
  options.yDown = true;
  ASSERT_EQ(picture.parse(asPixels(text), options), "");
  EXPECT_FALSE(picture.hasDepth);
  const TableFit a = fitted(samplesOf(space, regions)), b = fitted(samplesOf(picture, regions));
  for (int i = 0; i < 16; ++i)
    EXPECT_LT((a.table.maps[i].coefficients - b.table.maps[i].coefficients).cwiseAbs().maxCoeff(), 1e-9) << i + 1;
}
