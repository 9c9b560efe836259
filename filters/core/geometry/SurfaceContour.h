#pragma once

#include <utility>
#include <vector>

#include "PicturePlane.h"
#include "TriangleMesh.h"

namespace mien {

/// A line on a surface with the surface's unit normal at each of its points, and the direction in which what is seen
/// lies beside it, of any length; a closed one repeats its first point.
struct ContourLine {
  ClosedCurves::Points points, normals, inwards;
};

/// Where the surface turns away from the viewer: normal . out = 0, the normals linear along the edges of the triangles,
/// so that the contour is smooth where they are [Hertzmann and Zorin 2000].
/// @param normals  one row for each vertex
std::vector<ContourLine> silhouettes(const TriangleMesh& mesh, const ClosedCurves::Points& normals,
                                     const PicturePlane& plane);

/// Edges that one triangle only has: the rims of an open surface.
std::vector<ContourLine> borders(const TriangleMesh& mesh, const ClosedCurves::Points& normals);

/// Unit normals of the vertices, each the sum of its triangles' normals weighted with their areas.
ClosedCurves::Points vertexNormals(const TriangleMesh& mesh);

/// Pieces joined at common ends into lines as long as possible; a closed line repeats its first number.
std::vector<std::vector<int>> joinedPieces(const std::vector<std::pair<int, int>>& pieces);

}  // namespace mien
