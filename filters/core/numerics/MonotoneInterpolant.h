#pragma once

#include <utility>
#include <vector>

namespace mien {

/// A C1 function through knots (x, y) that never leaves the range of its two neighbouring knots, and is
/// constant beyond the first and last (Fritsch and Carlson 1980, with the harmonic mean of Brodlie).
class MonotoneInterpolant {
 public:
  MonotoneInterpolant() = default;

  /// Knots in any order; of those with the same x the mean is taken.
  explicit MonotoneInterpolant(std::vector<std::pair<double, double>> knots);

  double operator()(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace mien
