#pragma once

#include <vector>

#include "DeformationTable.h"

namespace mien {

/// Mean and standard deviation (n - 1; none of one table) of every coefficient over the tables that know its region;
/// `counts` says how many these are. Of a region that one table alone knows the deviations are 0 and no range. The
/// largest fitted displacement is that of all tables, and not known when one of them does not know it. At least one
/// table.
DeformationTable meanTable(const std::vector<DeformationTable>& tables);

/// How a coefficient (0 .. 11 for a1 .. b6) of a region (1 .. 16) lies to mean +- sd: -1 below, 1 above, 0 within, the
/// ends included. Within is also what differs from the mean by less than 0.005 of the largest coefficient of the mean's
/// map, which is about 1: that moves a point by less than 0.2 mm, and the deviations of regions that rest are smaller
/// still.
/// @param mean  with deviations
int sideOfRange(const DeformationTable& fit, const DeformationTable& mean, int region, int coefficient);

/// Coefficients of `fit` outside mean +- sd (sideOfRange()), as positions 12 (region - 1) + (0 .. 11 for a1 .. b6), in
/// the regions that are compared.
std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean);

/// Whether a region (1 .. 16) is known to the fit and has a range in the mean.
bool isCompared(const DeformationTable& fit, const DeformationTable& mean, int region);

}  // namespace mien
