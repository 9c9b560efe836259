#pragma once

#include <vector>

#include "TriangleMesh.h"

namespace mien {

/// For each vertex the first one at exactly its place, which may be itself.
std::vector<int> firstAtPlace(const TriangleMesh::Vertices& vertices);

/// Which triangles meet at an edge. Side i of triangle t runs from its corner i to the next and has the number 3 t + i;
/// the sides along one edge form a ring, of one where the surface ends: its rim, around it or around a hole.
///
/// Vertices at one place are one, so that seams of grids, textures and STL files are no rim. Triangles with two corners
/// at one place have no sides.
class EdgeRings {
 public:
  explicit EdgeRings(const TriangleMesh& mesh);

  int next(int side) const { return next_[side]; }  ///< -1 of a triangle without sides
  bool isRim(int side) const { return next_[side] == side; }
  bool isRimCorner(int vertex) const { return rimCorner_[first_[vertex]]; }
  int first(int vertex) const { return first_[vertex]; }  ///< vertex at this place

 private:
  std::vector<int> first_, next_;
  std::vector<bool> rimCorner_;
};

}  // namespace mien
