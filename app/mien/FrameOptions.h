#pragma once

#include <string>

namespace CLI {
class App;
}

namespace mien {

/// The options that choose frames of an animation.
struct FrameOptions {
  std::string range, start, end, fps, loop;

  void addTo(CLI::App& command);

  bool areChosen() const { return !(range + start + end + fps + loop).empty(); }

  /// The values of options. Throw a ValueFailure for text that is none.
  double rate() const;      ///< 0 when none is given
  int repetitions() const;  ///< 1 when none are given
};

}  // namespace mien
