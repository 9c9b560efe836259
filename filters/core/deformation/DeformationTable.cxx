#include "DeformationTable.h"

#include <algorithm>
#include <cmath>

namespace mien {

std::string DeformationTable::describeExcess() const {
  for (int i = 0; i < regionCount; ++i)
    if (!(maps[i].coefficients.cwiseAbs().maxCoeff() <= largestCoefficient))
      return "region " + std::to_string(i + 1) + " has a coefficient beyond -100 .. 100, which no face reaches";
  for (int i = 0; deviations && i < regionCount; ++i)
    if (!(deviations->at(i).cwiseAbs().maxCoeff() <= largestCoefficient))
      return "region " + std::to_string(i + 1) + " has a standard deviation beyond 100, which faces do not reach";
  return largestDisplacement <= largestCoefficient
             ? ""
             : "its largest displacement is beyond 100 pupil units, which no face reaches";
}

DeformationTable DeformationTable::blended(const DeformationTable& other, double fraction) const {
  DeformationTable result;
  for (int i = 0; i < regionCount; ++i)
    result.maps[i].coefficients = (1.0 - fraction) * maps[i].coefficients + fraction * other.maps[i].coefficients;
  const bool known = largestDisplacement > 0.0 && other.largestDisplacement > 0.0;
  result.largestDisplacement = known ? std::max(largestDisplacement, other.largestDisplacement) : 0.0;
  return result;
}

DeformationTable DeformationTable::weighted(const std::vector<std::pair<DeformationTable, double>>& tables) {
  if (tables.size() == 1 && tables.front().second == 1.0) return tables.front().first;
  DeformationTable result;
  double largest = 0.0;
  bool known = true;
  for (const auto& [table, weight] : tables) {
    for (int i = 0; i < regionCount; ++i)
      result.maps[i].coefficients += weight * (table.maps[i].coefficients - QuadraticMap::identity());
    largest += std::abs(weight) * table.largestDisplacement;
    known = known && table.largestDisplacement > 0.0;
  }
  result.largestDisplacement = known ? largest : 0.0;
  return result;
}

}  // namespace mien
