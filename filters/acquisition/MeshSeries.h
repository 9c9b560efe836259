#pragma once

#include <functional>
#include <vector>

#include "TriangleMesh.h"

namespace mien {

/// Decimates a mesh to several sizes in one go, by OpenMesh's quadric module [Garland and Heckbert 1997].
///
/// Triangles that would make an edge belong to three are left out.
/// @param triangles  numbers of triangles, largest first; a mesh may keep a few more where no edge can collapse
/// @param take       called with each mesh; false stops the series
/// @return false when it was stopped
bool decimateInSteps(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::function<bool(const TriangleMesh&)>& take);

}  // namespace mien
