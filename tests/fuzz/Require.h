#pragma once

#include <cstdlib>

/// Ends the program, which libFuzzer reports, unless the condition holds.
inline void require(bool holds) {
  if (!holds) std::abort();
}
