#include "MeshDistance.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double onEdge = 1e-9;  // share of a corner below which a point counts as lying on the opposite edge

int absentCorners(const Eigen::Vector3d& shares) {
  return static_cast<int>((shares.array() < onEdge).count());
}

int largestShare(const Eigen::Vector3d& shares) {
  int corner = 0;
  shares.maxCoeff(&corner);
  return corner;
}

/// The side of its triangle on which a point lies, from its corner with that number to the next.
int sideOf(const Eigen::Vector3d& shares) {
  int opposite = 0;
  shares.minCoeff(&opposite);
  return (opposite + 1) % 3;
}

/// Angle at the first of three points; 0 where two of them are one.
double angleAt(const Eigen::RowVector3d& corner, const Eigen::RowVector3d& one, const Eigen::RowVector3d& other) {
  const Eigen::RowVector3d a = one - corner, b = other - corner;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

MeshDistance::MeshDistance(const TriangleMesh& mesh)
    : triangles_(mesh.triangles),
      tree_(mesh),
      rings_(mesh),
      faceNormals_(mesh.triangles.rows(), 3),
      cornerNormals_(TriangleMesh::Vertices::Zero(mesh.vertices.rows(), 3)) {
  for (int t = 0; t < triangles_.rows(); ++t) {
    const auto corner = [&](int i) -> Eigen::RowVector3d { return mesh.vertices.row(triangles_(t, i % 3)); };
    const Eigen::RowVector3d area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    faceNormals_.row(t) = area.stableNormalized();
    for (int i = 0; i < 3; ++i)
      cornerNormals_.row(rings_.first(triangles_(t, i))) +=
          angleAt(corner(i), corner(i + 1), corner(i + 2)) * faceNormals_.row(t);
  }
}

/// The direction that is outside at a point of a triangle.
Eigen::Vector3d MeshDistance::outside(const TriangleTree::Nearest& found) const {
  const int absent = absentCorners(found.shares);
  if (absent == 0) return faceNormals_.row(found.triangle);
  if (absent >= 2) return cornerNormals_.row(rings_.first(triangles_(found.triangle, largestShare(found.shares))));
  const int side = 3 * found.triangle + sideOf(found.shares);
  Eigen::Vector3d sum = faceNormals_.row(found.triangle);
  for (int other = rings_.next(side); other >= 0 && other != side; other = rings_.next(other))
    sum += faceNormals_.row(other / 3).transpose();
  return sum;
}

bool MeshDistance::isOnRim(const TriangleTree::Nearest& found) const {
  const int absent = absentCorners(found.shares);
  if (absent == 0) return false;
  if (absent >= 2) return rings_.isRimCorner(triangles_(found.triangle, largestShare(found.shares)));
  return rings_.isRim(3 * found.triangle + sideOf(found.shares));
}

MeshDistance::Nearest MeshDistance::nearest(const Eigen::Vector3d& place) const {
  const TriangleTree::Nearest found = tree_.nearest(place);
  if (found.triangle < 0) return {found.squared, place};
  return {std::sqrt(found.squared), found.point, (place - found.point).dot(outside(found)) < 0.0, isOnRim(found)};
}

}  // namespace mien
