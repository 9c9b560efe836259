#include "FaceTemplate.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "FaceSample.h"
#include "MeshCleaning.h"

namespace mien {

namespace {

constexpr int sampledRows = 83, sampledColumns = 90;     // about 2 mm apart on the face
constexpr double frontHalfWidth = 113.0 * M_PI / 180.0;  // |v - pi| there: 80 degrees of azimuth, before the ears

/// The rows of a sample without those given twice at seams and at closed lips.
std::vector<int> differentRows(const FaceSample& sample) {
  std::vector<int> rows = {0};
  for (int row = 1; row < sample.rowCount(); ++row) {
    double largest = 0.0;
    for (int c = 0; c < sample.columnCount(); ++c)
      largest = std::max(largest, (sample.point(row, c) - sample.point(rows.back(), c)).norm());
    if (largest > 0.1) rows.push_back(row);
  }
  return rows;
}

std::vector<int> frontColumns(const FaceSample& sample) {
  std::vector<int> columns;
  for (int c = 0; c < sample.columnCount(); ++c)
    if (std::abs(sample.v(c) - M_PI) <= frontHalfWidth) columns.push_back(c);
  return columns;
}

TriangleMesh::Triangles gridTriangles(const FaceTemplate& face) {
  TriangleMesh::Triangles triangles(2 * (face.rows - 1) * (face.columns - 1), 3);
  int t = 0;
  for (int r = 0; r + 1 < face.rows; ++r)
    for (int c = 0; c + 1 < face.columns; ++c) {
      const int a = face.index(r, c), b = a + 1, d = face.index(r + 1, c);
      triangles.row(t++) << a, d, b;
      triangles.row(t++) << b, d, d + 1;
    }
  return triangles;
}

/// The point of a triangle that is nearest to p, as weights of its corners.
Eigen::Vector3d nearestWeights(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                               const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 3, 2> sides;
  sides << b - a, c - a;
  const Eigen::Matrix2d products = sides.transpose() * sides;
  if (!(products.determinant() > 0.0)) return Eigen::Vector3d::Unit(0);
  const Eigen::Vector2d w = products.inverse() * (sides.transpose() * (p - a));
  Eigen::Vector3d weights(1.0 - w.sum(), w[0], w[1]);
  weights = weights.cwiseMax(0.0);
  return weights / weights.sum();
}

FaceTemplate::Place placeOf(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  FaceTemplate::Place best;
  double nearest = std::numeric_limits<double>::infinity();
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3i ids = mesh.triangles.row(t);
    Eigen::Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.vertices.row(ids[i]);
    const Eigen::Vector3d weights = nearestWeights(corners.col(0), corners.col(1), corners.col(2), p);
    const Eigen::Vector3d offset = p - corners * weights;
    if (offset.norm() >= nearest) continue;
    nearest = offset.norm();
    best = {{ids[0], ids[1], ids[2]}, weights, offset};
  }
  return best;
}

}  // namespace

FaceLandmarks FaceTemplate::landmarksOn(const TriangleMesh::Vertices& points) const {
  FaceLandmarks result;
  for (int i = 0; i < FaceLandmarks::count; ++i) {
    Eigen::Vector3d p = places[i].offset;
    for (int k = 0; k < 3; ++k) p += places[i].weights[k] * points.row(places[i].corners[k]).transpose();
    result.points.row(i) = p.transpose();
  }
  return result;
}

FaceTemplate makeFaceTemplate(const FaceCurves& face, const FaceLandmarks& landmarks) {
  const FaceSample sample(face, FaceSurfaceOptions(), sampledRows, sampledColumns);
  const std::vector<int> rows = differentRows(sample), columns = frontColumns(sample);
  FaceTemplate result;
  result.rows = static_cast<int>(rows.size());
  result.columns = static_cast<int>(columns.size());
  result.mesh.vertices.resize(result.rows * result.columns, 3);
  for (int r = 0; r < result.rows; ++r)
    for (int c = 0; c < result.columns; ++c)
      result.mesh.vertices.row(result.index(r, c)) = sample.point(rows[r], columns[c]).transpose();
  result.mesh.triangles = gridTriangles(result);
  result.normals = outwardNormals(result.mesh);
  result.landmarks = landmarks;
  for (int i = 0; i < FaceLandmarks::count; ++i) result.places[i] = placeOf(result.mesh, landmarks[i]);
  return result;
}

}  // namespace mien
