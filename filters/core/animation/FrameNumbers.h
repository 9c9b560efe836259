#pragma once

#include <vector>

namespace mien {

/// Which frames of an even recording jittered times belong to, some frames being missing.
///
/// A step between frames is tried by following the times: each is given the number of the frame nearest to it, of a
/// grid whose phase moves a tenth of the way to every time, so that neither jitter nor a small error of the step adds
/// up; a line through numbers and times then gives the step again. Of several steps the one counts for which
/// root mean square jitter / step + 0.3 x the share of missing frames is least.
struct FrameNumbers {
  std::vector<double> numbers;  ///< per time, whole, from 0, ascending
  double start = 0.0;           ///< s, of frame 0 on the line
  double step = 0.0;            ///< s between frames
  double jitter = 0.0;          ///< root mean square distance of the times from the line, in steps
  double largestJitter = 0.0;   ///< in steps

  double missing() const { return numbers.back() + 1.0 - static_cast<double>(numbers.size()); }

  /// @param times at least two, strictly ascending, in s
  /// @param clockRate frames per second that the clock of the times counts, whose halves, doubles .. are tried; 0 for
  /// none
  static FrameNumbers of(const std::vector<double>& times, double clockRate);
};

}  // namespace mien
