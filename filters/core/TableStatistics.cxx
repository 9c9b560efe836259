#include "TableStatistics.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Coefficients = QuadraticMap::Coefficients;
constexpr int regionCount = DeformationTable::regionCount;

// A coefficient that never varied among the subjects must not decide alone.
constexpr double smallestDeviation = 1e-3;

DeformationTable::Deviations pooledDeviations(const std::vector<DeformationTable>& means) {
  DeformationTable::Deviations pooled;
  for (int i = 0; i < regionCount; ++i) {
    pooled[i].setZero();
    for (const DeformationTable& mean : means) pooled[i] += mean.deviations->at(i).cwiseAbs2();
    pooled[i] = (pooled[i] / double(means.size())).cwiseSqrt().cwiseMax(smallestDeviation);
  }
  return pooled;
}

RecognitionScore score(const DeformationTable& table, const DeformationTable& mean,
                       const DeformationTable::Deviations& deviations) {
  RecognitionScore result;
  double sum = 0.0;
  for (int i = 0; i < regionCount; ++i) {
    const Coefficients difference = table.maps[i].coefficients - mean.maps[i].coefficients;
    const double squares = difference.cwiseQuotient(deviations[i]).cwiseAbs2().array().log1p().sum();
    result.regions[i] = std::sqrt(squares / 12.0);
    sum += squares;
  }
  result.distance = std::sqrt(sum / (12.0 * regionCount));
  return result;
}

}  // namespace

DeformationTable meanTable(const std::vector<DeformationTable>& tables) {
  const double count = double(tables.size());
  DeformationTable mean;
  mean.deviations.emplace();
  for (int i = 0; i < regionCount; ++i) {
    Coefficients sum = Coefficients::Zero(), squares = Coefficients::Zero();
    for (const DeformationTable& table : tables) sum += table.maps[i].coefficients;
    mean.maps[i].coefficients = sum / count;
    for (const DeformationTable& table : tables)
      squares += (table.maps[i].coefficients - mean.maps[i].coefficients).cwiseAbs2();
    mean.deviations->at(i) = (squares / std::max(count - 1.0, 1.0)).cwiseSqrt();
  }
  for (const DeformationTable& table : tables)
    mean.largestDisplacement = std::max(mean.largestDisplacement, table.largestDisplacement);
  return mean;
}

std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean) {
  std::vector<int> outside;
  if (!mean.deviations) return outside;
  for (int i = 0; i < 12 * regionCount; ++i) {
    const int region = i / 12, row = i % 12 / 6, column = i % 6;
    const double difference = fit.maps[region].coefficients(row, column) - mean.maps[region].coefficients(row, column);
    if (std::abs(difference) > mean.deviations->at(region)(row, column)) outside.push_back(i);
  }
  return outside;
}

std::string recognise(const DeformationTable& table, const std::vector<DeformationTable>& means,
                      std::vector<RecognitionScore>& scores) {
  if (means.empty()) return "there is no table to compare with; give the mean tables of the expressions";
  for (std::size_t i = 0; i < means.size(); ++i)
    if (!means[i].deviations)
      return "table " + std::to_string(i + 1) + " has no standard deviations; give means over several subjects";
  const DeformationTable::Deviations deviations = pooledDeviations(means);
  scores.clear();
  for (std::size_t i = 0; i < means.size(); ++i) {
    scores.push_back(score(table, means[i], deviations));
    scores.back().expression = static_cast<int>(i);
  }
  std::stable_sort(scores.begin(), scores.end(),
                   [](const RecognitionScore& a, const RecognitionScore& b) { return a.distance < b.distance; });
  return {};
}

}  // namespace mien
