#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mien {

struct FAPSequence;

/// The frames that an option names by their numbers in the file, as indices from 0 in the order given: "5:9", "5:",
/// ":9", "1,5,9" or both, "1,5:9". Throws a ValueFailure that names the option for text that is none of these, and for
/// numbers that no frame carries.
std::vector<std::size_t> frameIndices(const std::string& option, const std::string& text, const FAPSequence& sequence);

/// Whether such text names single frames and not one range.
bool isFrameList(const std::string& text);

/// The options that choose frames of an animation.
struct FrameOptions {
  std::string range, frames, start, end, fps, loop;

  void addTo(CLI::App& command);

  bool areChosen() const { return !(range + frames + start + end + fps + loop).empty(); }

  /// --range or --frames, whichever was given, and its value; "" for all.
  const char* rangeOption() const { return frames.empty() ? "--range" : "--frames"; }
  const std::string& rangeText() const { return frames.empty() ? range : frames; }

  /// The values of options. Throw a ValueFailure for text that is none.
  double rate() const;      ///< 0 when none is given
  int repetitions() const;  ///< 1 when none are given
};

}  // namespace mien
