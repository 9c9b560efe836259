#pragma once

#include <string>
#include <string_view>

namespace mien {

/// What readers of meshes pass over in silence or never come back from: vertices that are no finite numbers, after
/// which every later index means another vertex, faces with a corner that the mesh does not have, counts that are not
/// kept, text that is cut off.
///
/// @param text    the whole file
/// @param ending  ".obj", ".off", ".ply" or ".stl" (as text); of others nothing is said
/// @return nothing, or one sentence with the first line (binary files: the number of the face) and what to do
std::string describeMeshTextFault(std::string_view text, const std::string& ending);

}  // namespace mien
