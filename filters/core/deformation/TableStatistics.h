#pragma once

#include <vector>

#include "DeformationTable.h"

namespace mien {

/// Mean and standard deviation (n - 1; none of one table) of every coefficient over the tables that know its region;
/// `counts` says how many these are. Of a region that one table alone knows the deviations are 0 and no range. The
/// largest fitted displacement is that of all tables, and not known when one of them does not know it. At least one
/// table.
DeformationTable meanTable(const std::vector<DeformationTable>& tables);

/// Coefficients of `fit` outside mean +- sd, as positions 12 (region - 1) + (0 .. 11 for a1 .. b6), in the regions
/// that are compared.
std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean);

/// Whether a region (1 .. 16) is known to the fit and has a range in the mean.
bool isCompared(const DeformationTable& fit, const DeformationTable& mean, int region);

}  // namespace mien
