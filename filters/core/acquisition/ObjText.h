#pragma once

#include "MeshText.h"

namespace mien {

/// Reads "v x y z" and "f 1/1/1 2/2/2 3/3/3" of an .obj file, corners counted from 1, or from the last vertex so far
/// where negative; see readMeshText(). All else is passed over.
std::optional<MeshFault> readObjText(std::string_view text, MeshText& read);

}  // namespace mien
