#pragma once

#include <vector>

#include "EdgeRings.h"
#include "TriangleTree.h"

namespace mien {

/// Distances of points to a fixed mesh. Safe to ask from several threads.
class MeshDistance {
 public:
  explicit MeshDistance(const TriangleMesh& mesh);

  /// The answer to one query.
  struct Nearest {
    double distance = 0.0;  ///< mm, never negative
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    bool isBehind = false;  ///< the place lies on the inner side, told by the normal of the nearest triangle, edge or
                            ///< corner [Baerentzen and Aanaes 2005, angle-weighted pseudonormals]
    bool onRim = false;     ///< the surface ends there: what is nearest is not opposite
  };

  Nearest nearest(const Eigen::Vector3d& place) const;

 private:
  Eigen::Vector3d outside(const TriangleTree::Nearest& found) const;
  bool isOnRim(const TriangleTree::Nearest& found) const;

  TriangleMesh::Triangles triangles_;
  TriangleTree tree_;
  EdgeRings rings_;
  TriangleMesh::Vertices faceNormals_, cornerNormals_;
};

}  // namespace mien
