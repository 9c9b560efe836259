#pragma once

#include <cstddef>
#include <vector>

#include "Progress.h"
#include "TriangleMesh.h"

namespace mien {

/// Which places of a mesh are joined by triangles, vertices at equal coordinates being one place: a mesh whose
/// triangles have corners of their own each (STL) is joined as it looks.
class PlaceNeighbors {
 public:
  /// Another corner of a triangle, with the cotangent of the angle opposite the edge that leads there (0.01 .. 10): by
  /// such weights a mean does not depend on which diagonals divide a grid of rectangles [Pinkall and Polthier 1993]. An
  /// edge of two triangles is met twice.
  struct Neighbor {
    int place;
    float weight;
  };
  /// Those of one place.
  struct Range {
    const Neighbor *first, *last;
    const Neighbor* begin() const { return first; }
    const Neighbor* end() const { return last; }
  };

  /// @param progress  not to go on leaves no place with any neighbour
  explicit PlaceNeighbors(const TriangleMesh& mesh, const Progress& progress = {});

  int count() const { return static_cast<int>(begin_.size()) - 1; }  ///< places
  int placeOf(int vertex) const { return placeOf_[vertex]; }         ///< 0 .. count() - 1
  Range around(int place) const { return {neighbors_.data() + begin_[place], neighbors_.data() + begin_[place + 1]}; }

 private:
  void numberPlaces(const TriangleMesh::Vertices& vertices);
  void countNeighbors(const TriangleMesh& mesh);
  bool fill(const TriangleMesh& mesh, const Progress& progress);

  std::vector<int> placeOf_;
  std::vector<std::size_t> begin_;  ///< of each place in neighbors_, and the end of the last
  std::vector<Neighbor> neighbors_;
};

}  // namespace mien
