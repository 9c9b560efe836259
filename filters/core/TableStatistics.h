#pragma once

#include "DeformationTable.h"

#include <string>
#include <vector>

namespace mien {

/// Mean and standard deviation (n - 1; zero for one table) of every coefficient. At least one table.
DeformationTable meanTable(const std::vector<DeformationTable>& tables);

/// Coefficients of `fit` outside mean +- sd, as positions 12 (region - 1) + (0 .. 11 for a1 .. b6). Empty without deviations.
std::vector<int> outsideRange(const DeformationTable& fit, const DeformationTable& mean);

/// How near a table is to an expression, and where the two differ most.
struct RecognitionScore {
  int expression = 0;                                           ///< index of the mean
  double distance = 0.0;                                        ///< root mean log(1 + z^2) of the scaled differences z; 0 is the mean itself
  std::array<double, DeformationTable::regionCount> regions{};  ///< the same for each region alone
};

/// Scores against the mean tables, nearest first: differences of coefficients divided by their standard deviation over the
/// recordings of one expression, pooled over the expressions, by the likelihood of a Cauchy distribution: log(1 + z^2), so
/// that the few coefficients that noisy or sparse regions leave wild do not outvote the others.
/// @return nothing, or one sentence that says which table has no deviations
std::string recognise(const DeformationTable& table, const std::vector<DeformationTable>& means,
                      std::vector<RecognitionScore>& scores);

}  // namespace mien
