#pragma once

#include <chrono>
#include <deque>
#include <optional>

namespace mien {

/// The longest vectors of the last two seconds, for scales that follow a moving face without trembling.
class RecentMotion {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds memory{2000};
  static constexpr std::size_t fewest = 10;  ///< pictures; of fewer nothing is known, whatever the time

  struct Lengths {
    double drawn = 0.0;    ///< mm, as the arrows are measured
    double colored = 0.0;  ///< mm, as the colours tell it
  };

  /// @return the most of what was added within the memory; nothing until that is full
  std::optional<Lengths> add(Time now, const Lengths& lengths);
  void clear() { entries_.clear(); }

 private:
  std::deque<std::pair<Time, Lengths>> entries_;
};

}  // namespace mien
