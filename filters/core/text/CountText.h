#pragma once

#include <cstddef>
#include <string>

namespace mien {

/// "1 frame", "2 frames": a count and what is counted, with an s unless there is one.
inline std::string countOf(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace mien
