#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mien {

/// Reads "v x y z" or "vertex x y z"; what follows is passed over.
/// @return nothing, or what is wrong, the word at fault named
std::string readVertexWords(const std::vector<std::string_view>& words, double (&place)[3]);

}  // namespace mien
