#include "RecentMotion.h"

#include <algorithm>

namespace mien {

/// One entry older than the memory is kept: it says that the memory is full.
std::optional<RecentMotion::Lengths> RecentMotion::add(Time now, const Lengths& lengths) {
  entries_.emplace_back(now, lengths);
  while (entries_.size() > fewest + 1 && now - entries_[1].first >= memory) entries_.pop_front();
  if (entries_.size() <= fewest || now - entries_.front().first < memory) return std::nullopt;
  Lengths most;
  for (auto entry = entries_.begin() + 1; entry != entries_.end(); ++entry) {
    most.drawn = std::max(most.drawn, entry->second.drawn);
    most.colored = std::max(most.colored, entry->second.colored);
  }
  return most;
}

}  // namespace mien
