#include "SurfaceOcclusion.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr int mostCellsAcross = 1024;

}  // namespace

SurfaceOcclusion::SurfaceOcclusion(const TriangleMesh& mesh, const PicturePlane& plane, double tolerance)
    : triangles_(mesh.triangles), tolerance_(tolerance), plane_(plane) {
  Eigen::Matrix3d axes;
  axes << plane.right, plane.up, plane.out;
  seen_ = mesh.vertices * axes;
  if (triangles_.rows() == 0) return;
  chooseCells();
  sortTriangles();
}

/// About one cell for each triangle that faces the viewer.
void SurfaceOcclusion::chooseCells() {
  low_ = seen_.leftCols<2>().colwise().minCoeff();
  const Eigen::Vector2d size = seen_.leftCols<2>().colwise().maxCoeff().transpose() - low_;
  const double across = std::clamp(std::sqrt(0.5 * triangles_.rows()), 1.0, 1.0 * mostCellsAcross);
  side_ = std::max(size.maxCoeff() / across, 1e-12);
  for (int axis = 0; axis < 2; ++axis)
    count_[axis] = std::min(1 + static_cast<int>(size[axis] / side_), mostCellsAcross + 1);
}

int SurfaceOcclusion::cellIndex(double value, int axis) const {
  return std::clamp(static_cast<int>((value - low_[axis]) / side_), 0, count_[axis] - 1);
}

SurfaceOcclusion::Cells SurfaceOcclusion::cellsOf(int triangle) const {
  Eigen::Array2d low(1e300, 1e300), high(-1e300, -1e300);
  for (int corner = 0; corner < 3; ++corner) {
    const Eigen::Array2d p = seen_.row(triangles_(triangle, corner)).head<2>().transpose();
    low = low.min(p);
    high = high.max(p);
  }
  return {cellIndex(low[0], 0), cellIndex(high[0], 0), cellIndex(low[1], 1), cellIndex(high[1], 1)};
}

/// Counts first, so that all lists share one block of memory.
void SurfaceOcclusion::sortTriangles() {
  const auto forCells = [&](const auto& use) {
    for (int triangle = 0; triangle < triangles_.rows(); ++triangle) {
      const Cells cells = cellsOf(triangle);
      for (int y = cells.bottom; y <= cells.top; ++y)
        for (int x = cells.left; x <= cells.right; ++x) use(y * count_[0] + x, triangle);
    }
  };
  begin_.assign(static_cast<size_t>(count_[0]) * count_[1] + 1, 0);
  forCells([&](int cell, int) { ++begin_[cell + 1]; });
  for (size_t cell = 1; cell < begin_.size(); ++cell) begin_[cell] += begin_[cell - 1];
  inCell_.resize(begin_.back());
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  forCells([&](int cell, int triangle) { inCell_[next[cell]++] = triangle; });
}

/// Nothing: the triangle is not there, or is seen from its edge.
std::optional<double> SurfaceOcclusion::depthOf(int triangle, const Eigen::Vector2d& at) const {
  const auto corner = [&](int i) { return seen_.row(triangles_(triangle, i)); };
  const auto side = [&](int i, int j) {
    return (corner(j)[0] - corner(i)[0]) * (at[1] - corner(i)[1]) -
           (corner(j)[1] - corner(i)[1]) * (at[0] - corner(i)[0]);
  };
  const double a = side(1, 2), b = side(2, 0), c = side(0, 1), sum = a + b + c;
  if (sum == 0.0 || a * sum < 0.0 || b * sum < 0.0 || c * sum < 0.0) return {};
  return (a * corner(0)[2] + b * corner(1)[2] + c * corner(2)[2]) / sum;
}

/// Until `use` says that it is enough.
template <class Use>
void SurfaceOcclusion::forTrianglesAt(const Eigen::Vector2d& at, const Use& use) const {
  if (begin_.empty()) return;
  const Eigen::Array2d place = (at - low_).array() / side_;
  if ((place < 0.0).any() || place[0] > count_[0] || place[1] > count_[1]) return;
  const int cell = cellIndex(at[1], 1) * count_[0] + cellIndex(at[0], 0);
  for (int i = begin_[cell]; i < begin_[cell + 1]; ++i)
    if (use(depthOf(inCell_[i], at))) return;
}

bool SurfaceOcclusion::hides(const Eigen::Vector3d& point) const {
  const double depth = plane_.depth(point);
  bool hidden = false;
  forTrianglesAt(plane_.project(point),
                 [&](std::optional<double> found) { return hidden = found && *found > depth + tolerance_; });
  return hidden;
}

std::optional<double> SurfaceOcclusion::frontDepth(const Eigen::Vector2d& at) const {
  std::optional<double> front;
  forTrianglesAt(at, [&](std::optional<double> found) {
    if (found && (!front || *found > *front)) front = found;
    return false;
  });
  return front;
}

}  // namespace mien
