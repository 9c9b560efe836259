#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "TriangleMesh.h"

namespace mien {

/// The nearest point of many triangles, by a binary tree of boxes around them: a query looks at a few dozen of them.
/// Safe to ask from several threads.
class TriangleTree {
 public:
  /// Keeps a copy of the corners, which must be finite; triangles without area count as the lines they are.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// The answer to one query.
  struct Nearest {
    int triangle = -1;  ///< -1 where there are none
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    Eigen::Vector3d shares = Eigen::Vector3d::Zero();  ///< of the corners in the point; exactly 0 on edge and corner
    double squared = std::numeric_limits<double>::infinity();  ///< distance
  };

  Nearest nearest(const Eigen::Vector3d& place) const;

 private:
  struct Face {
    Eigen::Vector3d a, b, c;
    int triangle;
    bool isLine;
  };
  struct Node {
    Eigen::AlignedBox3d box;
    int begin, end;  ///< faces
    int second;      ///< node; the first child is the next one; -1: a leaf
  };

  int build(int begin, int end);
  void descend(int node, const Eigen::Vector3d& place, Nearest& best) const;
  static void look(const Face& face, const Eigen::Vector3d& place, Nearest& best);

  std::vector<Face> faces_;
  std::vector<Node> nodes_;
};

}  // namespace mien
