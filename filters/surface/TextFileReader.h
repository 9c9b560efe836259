#pragma once

#include <cstddef>
#include <istream>
#include <string>

#include "MienSurfaceModule.h"

namespace mien {

/// All bytes of a file that has no more than `limit`; memory follows the file, not the limit. `what` names what it
/// should be, for messages ("warp mesh").
/// @return nothing, or what is wrong with it (" it cannot be opened ..", to be put behind `FILE:`)
MIENSURFACE_EXPORT std::string readTextFile(const std::string& name, std::size_t limit, std::string& text,
                                            const std::string& what = "file");

/// Appends what is left of a stream, block by block, until there are more than `limit` bytes.
MIENSURFACE_EXPORT void readBlocks(std::istream& stream, std::size_t limit, std::string& text);

}  // namespace mien
