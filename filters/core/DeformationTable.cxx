#include "DeformationTable.h"

#include <algorithm>

namespace mien {

DeformationTable DeformationTable::blended(const DeformationTable& other, double fraction) const {
  DeformationTable result;
  for (int i = 0; i < regionCount; ++i)
    result.maps[i].coefficients =
        (1.0 - fraction) * maps[i].coefficients + fraction * other.maps[i].coefficients;
  const bool known = largestDisplacement > 0.0 && other.largestDisplacement > 0.0;
  result.largestDisplacement = known ? std::max(largestDisplacement, other.largestDisplacement) : 0.0;
  return result;
}

}  // namespace mien
