#pragma once

#include <string>

#include "TriangleMesh.h"

namespace mien {

/// The ending of a file's name in small letters, with its dot.
std::string endingOf(const std::string& file);

/// Reads a scan (.ply, .obj, .stl, .off) through OpenMesh; polygons are triangulated. Lengths stay in the unit of the
/// file.
/// @return nothing, or one sentence that says what is wrong with the file and what to do
std::string readScanFile(const std::string& file, TriangleMesh& mesh);

}  // namespace mien
