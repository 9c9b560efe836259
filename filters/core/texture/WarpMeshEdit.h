#pragma once

#include <string>

#include "WarpMesh.h"

namespace mien {

/// A point of a warp mesh, counted from 0; a negative row: none.
struct MeshNode {
  int row = -1, column = -1;

  bool operator==(const MeshNode& other) const { return row == other.row && column == other.column; }
  bool operator!=(const MeshNode& other) const { return !(*this == other); }
};

/// The point of the mesh that is nearest to a place of its image (pixels), at most `reach` pixels away; or none.
MeshNode nearestNode(const WarpMesh& mesh, double x, double y, double reach);

/// Moves a point of the mesh by hand, to a place of its image (pixels); places beside the image are brought to its
/// border. Mirrored: the point of the same row on the other side of the middle column moves as far up and as far
/// outwards; points of the middle column move alone.
/// @return nothing, or one sentence that says which rows or columns would cross; the mesh is then as it was
std::string moveNode(WarpMesh& mesh, MeshNode node, double x, double y, bool mirrored);

}  // namespace mien
