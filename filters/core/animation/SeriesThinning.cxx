#include "SeriesThinning.h"

#include <algorithm>
#include <array>

namespace mien {

namespace {

constexpr std::size_t keptPerBin = 4;

}  // namespace

std::vector<std::pair<double, double>> thinnedSeries(const std::vector<double>& x, const std::vector<double>& y,
                                                     int bins) {
  std::vector<std::pair<double, double>> kept;
  const std::size_t count = std::min(x.size(), y.size());
  const bool few = count <= keptPerBin * bins;
  const double width = few ? 0.0 : (x[count - 1] - x[0]) / bins;
  for (std::size_t begin = 0, end; begin < count; begin = end) {
    const double edge = few ? x[begin] : x[0] + width * (1.0 + static_cast<int>((x[begin] - x[0]) / width));
    for (end = begin + 1; end < count && x[end] < edge;) ++end;
    const auto [least, most] = std::minmax_element(y.begin() + begin, y.begin() + end);
    std::array<std::size_t, keptPerBin> of = {begin, static_cast<std::size_t>(least - y.begin()),
                                              static_cast<std::size_t>(most - y.begin()), end - 1};
    std::sort(of.begin(), of.end());
    const auto last = std::unique(of.begin(), of.end());
    for (auto i = of.begin(); i != last; ++i) kept.emplace_back(x[*i], y[*i]);
  }
  return kept;
}

}  // namespace mien
