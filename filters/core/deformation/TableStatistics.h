#pragma once

#include <vector>

#include "DeformationTable.h"

namespace mien {

/// Mean and standard deviation (n - 1; none of one table) of every coefficient. The largest fitted displacement is that
/// of all tables, and not known when one of them does not know it. At least one table.
DeformationTable meanTable(const std::vector<DeformationTable>& tables);

/// Coefficients of `fit` outside mean +- sd, as positions 12 (region - 1) + (0 .. 11 for a1 .. b6). Empty without
/// deviations.
std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean);

}  // namespace mien
