#include "PlaceNeighbors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>

#include "EdgeRings.h"

namespace mien {

namespace {

constexpr double leastWeight = 0.01, mostWeight = 10.0;  // triangles may be without area
constexpr int trianglesPerStep = 1 << 16;

float weightOpposite(const TriangleMesh& mesh, int at, int one, int other) {
  const Eigen::Vector3d a = mesh.vertices.row(one) - mesh.vertices.row(at),
                        b = mesh.vertices.row(other) - mesh.vertices.row(at);
  const double sine = std::max(a.cross(b).norm(), std::numeric_limits<double>::min());
  return static_cast<float>(std::clamp(a.dot(b) / sine, leastWeight, mostWeight));
}

}  // namespace

PlaceNeighbors::PlaceNeighbors(const TriangleMesh& mesh, const Progress& progress) {
  numberPlaces(mesh.vertices);
  if (goesOn(progress, 0.5)) {
    countNeighbors(mesh);
    neighbors_.resize(begin_.back());
    if (fill(mesh, partOf(progress, 0.5, 1.0))) return;
  }
  std::fill(begin_.begin(), begin_.end(), 0);
}

void PlaceNeighbors::numberPlaces(const TriangleMesh::Vertices& vertices) {
  placeOf_ = firstAtPlace(vertices);
  int places = 0;
  for (size_t i = 0; i < placeOf_.size(); ++i)  // the first at a place comes before the others
    placeOf_[i] = placeOf_[i] == static_cast<int>(i) ? places++ : placeOf_[placeOf_[i]];
  begin_.assign(static_cast<size_t>(places) + 1, 0);
}

/// Every place's end, which fill() moves to its begin.
void PlaceNeighbors::countNeighbors(const TriangleMesh& mesh) {
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int one = placeOf_[mesh.triangles(t, i)], other = placeOf_[mesh.triangles(t, (i + 1) % 3)];
      if (one == other) continue;
      ++begin_[one];
      ++begin_[other];
    }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
}

bool PlaceNeighbors::fill(const TriangleMesh& mesh, const Progress& progress) {
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    if (t % trianglesPerStep == 0 && !goesOn(progress, double(t) / mesh.triangles.rows())) return false;
    for (int i = 0; i < 3; ++i) {
      const int at = mesh.triangles(t, i), a = mesh.triangles(t, (i + 1) % 3), b = mesh.triangles(t, (i + 2) % 3);
      const int one = placeOf_[a], other = placeOf_[b];
      if (one == other) continue;
      const float weight = weightOpposite(mesh, at, a, b);
      neighbors_[--begin_[one]] = {other, weight};
      neighbors_[--begin_[other]] = {one, weight};
    }
  }
  return true;
}

}  // namespace mien
