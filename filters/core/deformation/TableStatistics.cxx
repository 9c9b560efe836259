#include "TableStatistics.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

using Coefficients = QuadraticMap::Coefficients;
constexpr double leastOutside = 5e-3;  // of the largest coefficient of a map, to count

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

int sideOfRange(const DeformationTable& fit, const DeformationTable& mean, int region, int coefficient) {
  const int row = coefficient / 6, column = coefficient % 6;
  const QuadraticMap::Coefficients &fitted = fit.maps[region - 1].coefficients,
                                   &expected = mean.maps[region - 1].coefficients;
  const double difference = fitted(row, column) - expected(row, column);
  const double least = leastOutside * expected.cwiseAbs().maxCoeff();
  if (std::abs(difference) <= std::max(least, mean.deviations->at(region - 1)(row, column))) return 0;
  return difference < 0.0 ? -1 : 1;
}

std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean) {
  std::vector<int> outside;
  for (int i = 0; i < 12 * DeformationTable::regionCount; ++i) {
    const int region = i / 12 + 1;
    if (isCompared(fit, mean, region) && sideOfRange(fit, mean, region, i % 12) != 0) outside.push_back(i);
  }
  return outside;
}

}  // namespace mien
