#pragma once

#include <string>
#include <string_view>

namespace mien {

/// What readers of meshes pass over in silence: vertices that are no finite numbers, after which every later index
/// means another vertex, and faces with a corner that the mesh does not have.
///
/// @param text    the whole file
/// @param ending  ".obj", ".off" or ".ply"; of others, and where the text is no such file at all, nothing is said
/// @return nothing, or one sentence with the first line (binary files: the number of the face) and what to do
std::string describeMeshTextFault(std::string_view text, const std::string& ending);

}  // namespace mien
