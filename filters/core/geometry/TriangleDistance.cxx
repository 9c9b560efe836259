#include "TriangleDistance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {

namespace {

struct Corners {
  Eigen::Vector3d a, b, c;
};

double squaredToEdge(const Eigen::Vector3d& point, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (a + share * along - point).squaredNorm();
}

/// Whether the foot of the perpendicular lies within the triangle.
bool isAbove(const Eigen::Vector3d& point, const Corners& t, const Eigen::Vector3d& normal) {
  const auto inner = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return (to - from).cross(point - from).dot(normal) >= 0.0;
  };
  return inner(t.a, t.b) && inner(t.b, t.c) && inner(t.c, t.a);
}

double squaredToTriangle(const Eigen::Vector3d& point, const Corners& t) {
  const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a);
  const double size = normal.squaredNorm();
  if (size > 0.0 && isAbove(point, t, normal)) return std::pow((point - t.a).dot(normal), 2) / size;
  return std::min({squaredToEdge(point, t.a, t.b), squaredToEdge(point, t.b, t.c), squaredToEdge(point, t.c, t.a)});
}

}  // namespace

double distanceTo(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i) {
    const auto corners = mesh.triangles.row(i);
    const Corners t{mesh.vertices.row(corners[0]), mesh.vertices.row(corners[1]), mesh.vertices.row(corners[2])};
    const Eigen::Vector3d low = t.a.cwiseMin(t.b).cwiseMin(t.c), high = t.a.cwiseMax(t.b).cwiseMax(t.c);
    const double toBox = (point.cwiseMax(low).cwiseMin(high) - point).squaredNorm();
    if (toBox < nearest) nearest = std::min(nearest, squaredToTriangle(point, t));
  }
  return std::sqrt(nearest);
}

}  // namespace mien
