#pragma once

#include <Eigen/Core>

namespace mien {

/// A surface of triangles: vertices in mm, three vertex indices per triangle.
struct TriangleMesh {
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> vertices;
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles;
};

}  // namespace mien
