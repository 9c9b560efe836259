#pragma once

#include <optional>
#include <vector>

#include "PicturePlane.h"
#include "TriangleMesh.h"

namespace mien {

/// Says which points a surface hides in a picture: those that a triangle covers from in front. Exact for the triangles,
/// which are found through a grid of cells over the picture.
class SurfaceOcclusion {
 public:
  /// @param tolerance  how far behind the surface a point still counts as on it, mm; 0 up
  SurfaceOcclusion(const TriangleMesh& mesh, const PicturePlane& plane, double tolerance = 1.0);

  bool hides(const Eigen::Vector3d& point) const;

  /// How near the viewer the surface comes at a place of the picture, mm along `out`; nothing: it is not there.
  std::optional<double> frontDepth(const Eigen::Vector2d& at) const;

 private:
  struct Cells {
    int left, right, bottom, top;
  };
  Cells cellsOf(int triangle) const;
  int cellIndex(double value, int axis) const;
  std::optional<double> depthOf(int triangle, const Eigen::Vector2d& at) const;
  template <class Use>
  void forTrianglesAt(const Eigen::Vector2d& at, const Use& use) const;
  void chooseCells();
  void sortTriangles();

  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> seen_;  ///< right, up, depth of each vertex
  Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> triangles_;
  double tolerance_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();
  double side_ = 1.0;  ///< of a cell, mm
  int count_[2] = {1, 1};
  PicturePlane plane_;
  std::vector<int> begin_, inCell_;  ///< triangles of cell c: inCell_[begin_[c] .. begin_[c + 1])
};

}  // namespace mien
