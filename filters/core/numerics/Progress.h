#pragma once

#include <functional>

namespace mien {

/// Told how much of a long computation is done (0 .. 1); answers whether to go on. May be empty.
using Progress = std::function<bool(double)>;

inline bool goesOn(const Progress& progress, double done) {  ///< tells it, if anybody wants to know
  return !progress || progress(done);
}

/// The part `from` .. `to` of a computation, as a progress of its own.
inline Progress partOf(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [progress, from, to](double done) { return progress(from + (to - from) * done); };
}

}  // namespace mien
