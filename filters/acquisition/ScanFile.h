#pragma once

#include <string>

#include "MeshText.h"

namespace mien {

/// The ending of a file's name in small letters, with its dot.
std::string endingOf(const std::string& file);

/// Reads a scan (.ply, .obj, .stl, .off); polygons are triangulated (MeshText.h). Lengths stay in the unit of the file.
/// @return nothing, or one sentence that says what is wrong with the file and what to do: "FILE: ..", "FILE:LINE: .."
std::string readScanFile(const std::string& file, MeshText& scan);

}  // namespace mien
