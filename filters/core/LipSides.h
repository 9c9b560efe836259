#pragma once

#include "FacialRegions.h"
#include "TriangleMesh.h"

#include <array>
#include <string>
#include <vector>

namespace mien {

using MeshEdges = std::vector<std::array<int, 2>>;

/// The edges of a mesh's triangles; those between two triangles may come twice.
MeshEdges edgesOf(const TriangleMesh& mesh);

/// The side of the lip line of every vertex, from distances along the surface: the difference of the distances to the lower
/// and to the upper inner lip, divided by the mouth's half width and kept within -1 .. 1. It jumps across the lip line only and is
/// 0 at the mouth corners and on the skin beside them. Vertices that no path joins to a lip are at 0.
/// Seeds are vertices on the inner contour of each lip, between the corners; edges are pairs of vertex indices. All valid.
std::vector<LipSide> lipSides(const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>& vertices,
                              const MeshEdges& edges, const std::vector<int>& upper, const std::vector<int>& lower,
                              double halfWidth);

}  // namespace mien
