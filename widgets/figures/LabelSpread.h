#pragma once

#include <vector>

namespace mien {

/// Places for labels along a line, in the order given and at least `gap` apart, that lie as near as possible (least
/// squares) to where they are wanted.
///
/// @param wanted  ascending
std::vector<double> spreadLabels(const std::vector<double>& wanted, double gap);

}  // namespace mien
