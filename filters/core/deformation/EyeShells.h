#pragma once

#include "FaceSides.h"

namespace mien {

/// Which vertices belong to an eye and not to the skin: parts of the mesh (by its edges) that are about spheres around
/// a pupil, as eyeballs and corneas are, and all parts that lie wholly within the box of one. A part is one when its
/// vertices lie within a tenth of the radius (root mean square) about a sphere of 0.2 to 0.8 pupil units whose centre,
/// seen from the front, is at most 0.35 beside the pupil.
/// @param vertices  pupil units: the pupils at (1, 0) and (-1, 0), whatever their depth
std::vector<bool> eyeShells(const MeshVertices& vertices, const MeshEdges& edges);

}  // namespace mien
