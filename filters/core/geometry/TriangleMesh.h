#pragma once

#include <Eigen/Core>

namespace mien {

/// A surface of triangles: vertices in mm, three vertex indices per triangle.
struct TriangleMesh {
  using Vertices = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  using Triangles = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

  Vertices vertices;
  Triangles triangles;
};

}  // namespace mien
