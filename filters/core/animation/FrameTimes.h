#pragma once

#include <optional>
#include <vector>

#include "FAPLineParser.h"
#include "FAPSequence.h"

namespace mien {

/// When the rows of a table were recorded.
struct FrameTimes {
  std::vector<double> seconds;  ///< one per frame, any start
  std::vector<int> lines;       ///< where they stand in the file
  double clockError = 1.1e-3;   ///< s that a time may be off; many are rounded to milliseconds

  /// Gives a sequence of as many frames its rate, and even steps: the rate is that of the usual step (whole where the
  /// times allow it); rows that repeat a time are left out, and gaps are filled with mixtures of the frames around
  /// them. Both are warned of. Without two different times the rate stays as it is.
  /// @return the line where time goes back, or jumps too far to fill; the sequence is then as it was
  std::optional<FAPParseError> place(FAPSequence& sequence) const;
};

/// The animation at another rate, from its first frame to its last, mixed from the frames around each moment; nothing
/// when that were more than a million frames.
std::optional<FAPSequence> resampled(const FAPSequence& sequence, double framesPerSecond);

}  // namespace mien
