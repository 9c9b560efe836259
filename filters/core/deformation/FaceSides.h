#pragma once

#include <array>
#include <string>
#include <vector>

#include "FacialRegions.h"
#include "Progress.h"
#include "TriangleMesh.h"

namespace mien {

using MeshVertices = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using MeshEdges = std::vector<std::array<int, 2>>;
using LandmarkVertices = std::array<int, 68>;  ///< vertex of each of the 68 landmarks of Multi-PIE

/// The edges of a mesh's triangles; those between two triangles may come twice.
MeshEdges edgesOf(const TriangleMesh& mesh);

/// Lips or lids of a mesh: vertices on the inner contour of either side, between the corners, and lengths in the mesh's
/// unit.
struct MeshSlit {
  std::vector<int> upper, lower;
  double halfWidth = 0.0;  ///< half the distance of the corners
  double reach = 0.0;      ///< where the sides have faded to 0
};

/// The side of a slit of every vertex, from distances along the surface: the difference of the distances to its lower
/// and to its upper contour, divided by the half width and kept within -1 .. 1, fading with the distance to the nearer
/// one. It jumps across the slit only and is 0 at the corners, on the skin beside them, and where no path leads to both
/// contours. Edges are pairs of vertex indices. All indices valid.
std::vector<double> slitSides(const MeshVertices& vertices, const MeshEdges& edges, const MeshSlit& slit);

/// Sides of lips and lids of a mesh with the 68 landmarks as vertex indices.
/// @param unit  length of one pupil unit
/// @param progress  sides are none where it says stop
std::vector<FaceSide> faceSides(const MeshVertices& vertices, const MeshEdges& edges, const LandmarkVertices& landmarks,
                                const FacialRegions& regions, double unit, const Progress& progress = {});

/// The number (0 .. 67) of the landmark that a marker's name says it is ("landmark08", "landmark8"); -1 for any other.
int landmarkNumber(const std::string& name);

/// The side of a marker by the landmark it is: its number of the 68, no side for any other.
FaceSide landmarkSide(int landmark);

}  // namespace mien
