#pragma once

#include <cstddef>
#include <string>

#include "MienDeformationModule.h"

namespace mien {

/// All bytes of a file that is smaller than `limit`.
/// @return nothing, or what is wrong with it (" it cannot be opened ..", to be put behind `FILE:`)
MIENDEFORMATION_EXPORT std::string readTextFile(const std::string& name, std::size_t limit, std::string& text);

}  // namespace mien
