#pragma once

#include <functional>
#include <vector>

#include "Progress.h"
#include "TriangleMesh.h"

namespace mien {

/// Decimates a mesh to several sizes in one go, by OpenMesh's quadric module [Garland and Heckbert 1997]: edges
/// collapse that move the surface least.
///
/// Triangles that would make an edge belong to three are left out.
/// @param triangles  numbers of triangles, largest first; a mesh may keep a few more where no edge can collapse
/// @param take       called with each mesh; false stops the series
/// @param progress   of the collapses alone; can stop them too
/// @return false when it was stopped
bool decimateInSteps(const TriangleMesh& mesh, const std::vector<int>& triangles,
                     const std::function<bool(const TriangleMesh&)>& take, const Progress& progress = {});

/// The same to one size, in place. A mesh with no more triangles stays as it is, and so does one that was stopped.
bool decimate(TriangleMesh& mesh, int triangles, const Progress& progress = {});

}  // namespace mien
