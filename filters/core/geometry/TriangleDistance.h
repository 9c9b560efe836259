#pragma once

#include "TriangleMesh.h"

namespace mien {

/// The distance of a point to the nearest point of a mesh, found among all triangles: for a few points at a time.
/// Infinite for a mesh without triangles.
double distanceTo(const TriangleMesh& mesh, const Eigen::Vector3d& point);

}  // namespace mien
