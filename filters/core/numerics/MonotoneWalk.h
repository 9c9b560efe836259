#pragma once

#include <cstddef>

namespace mien {

/// A C1 function through knots that never leaves the range of its two neighbouring knots (Fritsch and Carlson 1980,
/// with the harmonic mean of Brodlie), read at ascending places an equal step of 1 apart: no search, no memory of its
/// own. Its ends have the slope of the first and last chord, so that knots on a line give that line; beyond them it is
/// constant. MonotoneInterpolant is the same for single places, and flat at its ends.
class MonotoneWalk {
 public:
  /// @param from  ascending, `count` of them, `stride` apart; both must outlive the walk
  MonotoneWalk(const double* from, const double* to, int count, std::ptrdiff_t stride = 1)
      : from_(from), to_(to), last_(count - 1), stride_(stride) {}

  /// The values at first, first + 1, ..., `places` of them, `resultStride` apart.
  void follow(double first, int places, double* result, std::ptrdiff_t resultStride = 1) const;

 private:
  struct Cubic {
    double value, slope, second, third;
    double at(double x) const { return value + x * (slope + x * (second + x * third)); }
  };

  double from(int k) const { return from_[k * stride_]; }
  double to(int k) const { return to_[k * stride_]; }
  double width(int k) const { return from(k + 1) - from(k); }
  double rise(int k) const { return (to(k + 1) - to(k)) / width(k); }
  double slope(int k) const;
  Cubic piece(int k) const;

  const double* from_;
  const double* to_;
  int last_;
  std::ptrdiff_t stride_;
};

}  // namespace mien
