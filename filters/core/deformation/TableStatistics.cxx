#include "TableStatistics.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Coefficients = QuadraticMap::Coefficients;
constexpr int regionCount = DeformationTable::regionCount;

}  // namespace

DeformationTable meanTable(const std::vector<DeformationTable>& tables) {
  const double count = double(tables.size());
  DeformationTable mean;
  if (tables.size() > 1) mean.deviations.emplace();
  for (int i = 0; i < regionCount; ++i) {
    Coefficients sum = Coefficients::Zero(), squares = Coefficients::Zero();
    for (const DeformationTable& table : tables) sum += table.maps[i].coefficients;
    mean.maps[i].coefficients = sum / count;
    for (const DeformationTable& table : tables)
      squares += (table.maps[i].coefficients - mean.maps[i].coefficients).cwiseAbs2();
    if (mean.deviations) mean.deviations->at(i) = (squares / (count - 1.0)).cwiseSqrt();
  }
  bool known = true;
  for (const DeformationTable& table : tables) {
    mean.largestDisplacement = std::max(mean.largestDisplacement, table.largestDisplacement);
    known = known && table.largestDisplacement > 0.0;
  }
  if (!known) mean.largestDisplacement = 0.0;
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

}  // namespace mien
