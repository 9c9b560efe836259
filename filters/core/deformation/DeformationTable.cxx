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

std::vector<int> DeformationTable::unknownRegions() const {
  std::vector<int> unknown;
  for (int region = 1; region <= regionCount; ++region)
    if (!this->knows(region)) unknown.push_back(region);
  return unknown;
}

void DeformationTable::keepKnown(const std::vector<const DeformationTable*>& parts) {
  const bool complete =
      std::all_of(parts.begin(), parts.end(), [](const auto* part) { return part->unknownRegions().empty(); });
  counts.reset();
  if (complete) return;
  counts.emplace();
  for (int region = 1; region <= regionCount; ++region)
    counts->at(region - 1) = static_cast<int>(
        std::count_if(parts.begin(), parts.end(), [&](const auto* part) { return part->knows(region); }));
}

DeformationTable DeformationTable::blended(const DeformationTable& other, double fraction) const {
  DeformationTable result;
  for (int i = 0; i < regionCount; ++i)
    result.maps[i].coefficients = (1.0 - fraction) * maps[i].coefficients + fraction * other.maps[i].coefficients;
  const bool known = largestDisplacement > 0.0 && other.largestDisplacement > 0.0;
  result.largestDisplacement = known ? std::max(largestDisplacement, other.largestDisplacement) : 0.0;
  result.keepKnown({this, &other});
  return result;
}

DeformationTable DeformationTable::weighted(const std::vector<std::pair<DeformationTable, double>>& tables) {
  if (tables.size() == 1 && tables.front().second == 1.0) return tables.front().first;
  DeformationTable result;
  double largest = 0.0;
  bool known = true;
  std::vector<const DeformationTable*> parts;
  for (const auto& [table, weight] : tables) {
    parts.push_back(&table);
    for (int i = 0; i < regionCount; ++i)
      result.maps[i].coefficients += weight * (table.maps[i].coefficients - QuadraticMap::identity());
    largest += std::abs(weight) * table.largestDisplacement;
    known = known && table.largestDisplacement > 0.0;
  }
  result.largestDisplacement = known ? largest : 0.0;
  result.keepKnown(parts);
  return result;
}

}  // namespace mien
