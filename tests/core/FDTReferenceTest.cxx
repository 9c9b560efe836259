#include "ReferenceData.h"
#include "RegionMap.h"
#include "TableFit.h"
#include "TableStatistics.h"
#include "TextFile.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

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
int recognised(const std::vector<DeformationTable>& clean, const std::vector<DeformationTable>& shown) {
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
  for (const TableSamples& samples : allSamples(regionMap())) tables.push_back(fitted(samples).table);
  const int right = recognised(tables, tables);
  RecordProperty("recognised", right);
  EXPECT_GE(right, 70);
}

TEST(FDTReference, RecognisesThroughNoise) {
  MIEN_REQUIRE_REFERENCE("markers");
  std::mt19937 random(1);
  std::vector<DeformationTable> tables;
  const std::vector<TableSamples> recordings = allSamples(regionMap());
  for (const TableSamples& samples : recordings) tables.push_back(fitted(samples).table);
  constexpr int repetitions = 5;
  int right = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::vector<DeformationTable> shown;
    for (const TableSamples& samples : recordings) shown.push_back(fitted(noisy(samples, 0.05, random)).table);
    right += recognised(tables, shown);
  }
  EXPECT_GE(right, repetitions * 68);
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
