#pragma once

#include <cstddef>
#include <string>

namespace mien {

/// All bytes of a file that is smaller than `limit`.
/// @return nothing, or what is wrong with it (" it cannot be opened ..", to be put behind `FILE:`)
std::string readTextFile(const std::string& name, std::size_t limit, std::string& text);

}  // namespace mien
