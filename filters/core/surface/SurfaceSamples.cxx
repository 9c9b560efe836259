#include "SurfaceSamples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr int mostCuts = 1000;  // of an edge: a million samples of one triangle

struct Corners {
  Eigen::Vector3d a, b, c;

  Corners(const TriangleMesh& mesh, int triangle)
      : a(mesh.vertices.row(mesh.triangles(triangle, 0))),
        b(mesh.vertices.row(mesh.triangles(triangle, 1))),
        c(mesh.vertices.row(mesh.triangles(triangle, 2))) {}

  double longestEdge() const {
    return std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }
  double area() const { return 0.5 * (b - a).cross(c - a).norm(); }
  Eigen::Vector3d at(double towardsB, double towardsC) const { return a + towardsB * (b - a) + towardsC * (c - a); }
};

/// Middles of the n x n parts: those that stand like the triangle, and those upside down between them.
template <class Take>
void forParts(const Corners& corners, int n, const Take& take) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      take(corners.at((i + 1.0 / 3.0) / n, (j + 1.0 / 3.0) / n));
      if (i + j + 1 < n) take(corners.at((i + 2.0 / 3.0) / n, (j + 2.0 / 3.0) / n));
    }
}

}  // namespace

SurfaceSamples::SurfaceSamples(const TriangleMesh& mesh, double spacing,
                               const std::function<bool(const Eigen::Vector3d&)>& counts) {
  const auto add = [&](const Eigen::Vector3d& point, double area) {
    if (!counts(point)) return;
    points.push_back(point);
    areas.push_back(area);
  };
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Corners corners(mesh, t);
    const int n = std::clamp(static_cast<int>(std::ceil(corners.longestEdge() / spacing)), 1, mostCuts);
    forParts(corners, n, [&](const Eigen::Vector3d& middle) { add(middle, corners.area() / (n * n)); });
  }
  for (int i = 0; i < mesh.vertices.rows(); ++i) add(mesh.vertices.row(i), 0.0);
}

}  // namespace mien
