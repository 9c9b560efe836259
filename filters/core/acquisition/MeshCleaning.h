#pragma once

#include <vector>

#include "TriangleMesh.h"

namespace mien {

/// A scan whose vertices are one per place and whose triangles have area.
struct CleanMesh {
  TriangleMesh mesh;
  int mergedVertices = 0;       ///< that lay where another lies
  int degenerateTriangles = 0;  ///< without area, or given twice
};

/// Merges vertices at the same place, which STL files and texture seams have, and drops triangles without area,
/// triangles given twice and vertices that no triangle uses. The order of what stays is kept.
CleanMesh cleaned(const TriangleMesh& mesh);

/// The parts of a mesh that share no vertex.
struct MeshParts {
  std::vector<int> ofTriangle;          ///< part of each triangle; part 0 has the largest area
  std::vector<double> area;             ///< mm2, falling
  std::vector<Eigen::Vector3d> middle;  ///< of the box around each part
  std::vector<double> size;             ///< diagonal of that box, mm

  int count() const { return static_cast<int>(area.size()); }
};

/// The connected parts of a mesh, the largest first.
MeshParts partsOf(const TriangleMesh& mesh);

/// Only the triangles whose part is wanted; vertices without triangles go.
TriangleMesh withParts(const TriangleMesh& mesh, const MeshParts& parts, const std::vector<bool>& wanted);

/// Only these triangles, which refer to the vertices, and the vertices they use, in their old order.
TriangleMesh withTriangles(const TriangleMesh::Vertices& vertices, const std::vector<Eigen::Vector3i>& triangles);

/// Closed lines of edges that one triangle alone has (EdgeRings): holes, and the rim of an open scan.
int boundaryLoops(const TriangleMesh& mesh);

/// Volume between the triangles and the mean of the vertices, mm3: negative where they are wound inwards. An opening,
/// as at the neck, takes little of it.
double signedVolume(const TriangleMesh& mesh);

/// Normals of the vertices, weighted with the area around them; outwards as a whole, whatever the winding of the file.
TriangleMesh::Vertices outwardNormals(const TriangleMesh& mesh);

}  // namespace mien
