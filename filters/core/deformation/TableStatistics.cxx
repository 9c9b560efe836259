#include "TableStatistics.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Coefficients = QuadraticMap::Coefficients;

}  // namespace

DeformationTable meanTable(const std::vector<DeformationTable>& tables) {
  DeformationTable mean;
  mean.counts.emplace();
  if (tables.size() > 1) mean.deviations.emplace();
  for (int i = 0; i < DeformationTable::regionCount; ++i) {
    std::vector<Coefficients> known;
    for (const DeformationTable& table : tables)
      if (table.knows(i + 1)) known.push_back(table.maps[i].coefficients);
    const double count = double(known.size());
    mean.counts->at(i) = static_cast<int>(known.size());
    if (mean.deviations) mean.deviations->at(i).setZero();
    if (known.empty()) continue;
    Coefficients sum = Coefficients::Zero(), squares = Coefficients::Zero();
    for (const Coefficients& coefficients : known) sum += coefficients;
    mean.maps[i].coefficients = sum / count;
    for (const Coefficients& coefficients : known) squares += (coefficients - sum / count).cwiseAbs2();
    if (known.size() > 1) mean.deviations->at(i) = (squares / (count - 1.0)).cwiseSqrt();
  }
  bool known = true;
  for (const DeformationTable& table : tables) {
    mean.largestDisplacement = std::max(mean.largestDisplacement, table.largestDisplacement);
    known = known && table.largestDisplacement > 0.0;
  }
  if (!known) mean.largestDisplacement = 0.0;
  return mean;
}

bool isCompared(const DeformationTable& fit, const DeformationTable& mean, int region) {
  return fit.knows(region) && mean.hasRange(region);
}

std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean) {
  std::vector<int> outside;
  for (int i = 0; i < 12 * DeformationTable::regionCount; ++i) {
    const int region = i / 12, row = i % 12 / 6, column = i % 6;
    if (!isCompared(fit, mean, region + 1)) continue;
    const double difference = fit.maps[region].coefficients(row, column) - mean.maps[region].coefficients(row, column);
    if (std::abs(difference) > mean.deviations->at(region)(row, column)) outside.push_back(i);
  }
  return outside;
}

}  // namespace mien
