#pragma once

#include <cstdint>
#include <istream>
#include <string>

#include "MienSurfaceModule.h"

namespace mien {

/// One sentence about the first count in a VTK XML file (NumberOfPoints and its like, an extent) that is negative or
/// that no file of this length can hold, or nothing. Reads as far as the data begin.
///
/// @param size  bytes of the file: every value takes at least one, or a thousandth of one where the file is compressed
MIENSURFACE_EXPORT std::string describeCountFault(std::istream& file, std::uintmax_t size);

}  // namespace mien
