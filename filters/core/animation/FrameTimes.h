#pragma once

#include <optional>
#include <string>
#include <vector>

#include "FAPLineParser.h"
#include "FAPSequence.h"

namespace mien {

/// When the rows of a table were recorded.
struct FrameTimes {
  std::vector<double> seconds;       ///< one per frame, any start
  std::vector<int> lines;            ///< where they stand in the file
  std::vector<int> lostBefore = {};  ///< rows without a face directly before each, told elsewhere; empty for none
  double clockError = 1.1e-3;        ///< s that a time may be off; many are rounded to milliseconds
  double clockRate = 0.0;            ///< frames per second that a time code counts; 0 for times in s
  bool hasNumbers = false;           ///< the frames carry numbers of the file, which stay; else they are counted from 0

  /// Gives a sequence of as many frames its rate, and even steps. The rate is the mean over all frames, present and
  /// missing (FrameNumbers.h); where the times leave room for it a whole one, 1000/1001 of one, or the nearest usual
  /// one. Rows that repeat a time are left out, and gaps are filled with mixtures of the frames around them. Both are
  /// warned of. Without two different times the rate stays as it is.
  /// @return the line where time goes back, or jumps too far to fill; the sequence is then as it was
  std::optional<FAPParseError> place(FAPSequence& sequence) const;
};

/// Says that 25 frames per second are assumed, as there is no time, or too little of it.
std::string describeAssumedRate(bool hasTime);

/// The animation at another rate, from its first frame to its last, mixed from the frames around each moment; nothing
/// when that were more than a million frames.
std::optional<FAPSequence> resampled(const FAPSequence& sequence, double framesPerSecond);

}  // namespace mien
