#pragma once

#include <vector>

#include "DeformationTable.h"

namespace mien {

/// Mean and standard deviation (n - 1; zero for one table) of every coefficient. At least one table.
DeformationTable meanTable(const std::vector<DeformationTable>& tables);

/// Coefficients of `fit` outside mean +- sd, as positions 12 (region - 1) + (0 .. 11 for a1 .. b6). Empty without
/// deviations.
std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean);

}  // namespace mien
