#pragma once

#include <string>
#include <vector>

namespace mien {

/// The intervals of a piecewise linear motion: ascending borders in FAP values, one of them 0.
///
/// To evaluate, one walks from 0 to the value and adds slope x length for every interval crossed and
/// slope x the part reached for the last. Beyond the outer borders the outer slope goes on.
class PiecewiseLinear {
 public:
  static constexpr std::size_t mostBorders = 64;  ///< every interval keeps a field of displacements

  PiecewiseLinear() = default;

  /// @return nothing, or one sentence that says what is wrong with the borders
  std::string setBorders(const std::vector<double>& borders);

  int intervals() const { return static_cast<int>(borders_.size()) - 1; }
  const std::vector<double>& borders() const { return borders_; }

  /// The signed length that the walk from 0 to `value` covers in an interval; their sum is `value`.
  double length(int interval, double value) const;

 private:
  std::vector<double> borders_ = {0.0, 1.0};
};

}  // namespace mien
