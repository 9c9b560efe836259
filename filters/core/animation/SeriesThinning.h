#pragma once

#include <utility>
#include <vector>

namespace mien {

/// A long series with fewer points that looks the same: of every bin of equal width in x the first, the last, the
/// smallest and the largest value stay, in their order.
/// @param x     ascending
/// @param bins  above 0; a series of no more than four points a bin stays as it is
std::vector<std::pair<double, double>> thinnedSeries(const std::vector<double>& x, const std::vector<double>& y,
                                                     int bins);

}  // namespace mien
