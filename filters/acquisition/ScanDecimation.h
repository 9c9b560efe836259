#pragma once

#include "TriangleMesh.h"

namespace mien {

/// Collapses edges until at most `triangles` are left, those first that move the surface least [Garland and Heckbert
/// 1997, quadric error], by OpenMesh. A mesh with fewer stays as it is; triangles that would make an edge belong to
/// three are left out.
void decimate(TriangleMesh& mesh, int triangles);

}  // namespace mien
