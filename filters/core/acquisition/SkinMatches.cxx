#include "SkinMatches.h"

#include "MeshCleaning.h"

namespace mien {

namespace {

constexpr double leastFacing = 0.4;  // cosine between normals
constexpr double softness = 0.1;     // of the reach, squared: from there on distance costs weight

}  // namespace

SkinMatches::SkinMatches(const TriangleMesh& scan)
    : points_(scan.vertices), normals_(outwardNormals(scan)), tree_(points_) {}

std::vector<SkinMatch> SkinMatches::of(const TriangleMesh& face, double reach) const {
  const Points faceNormals = outwardNormals(face);
  std::vector<SkinMatch> matches(static_cast<size_t>(face.vertices.rows()));
  for (Eigen::Index i = 0; i < face.vertices.rows(); ++i) {
    const int q = tree_.nearest(face.vertices.row(i), reach);
    if (q < 0) continue;
    const double facing = normals_.row(q).dot(faceNormals.row(i));
    if (facing < leastFacing) continue;
    const double gap = normals_.row(q).dot(points_.row(q) - face.vertices.row(i));
    matches[i] = {q, gap, facing * facing / (1.0 + gap * gap / (softness * reach * reach))};
  }
  return matches;
}

}  // namespace mien
