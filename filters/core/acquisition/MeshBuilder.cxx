#include "MeshBuilder.h"

#include <algorithm>
#include <limits>

namespace mien {

void MeshBuilder::count(std::size_t corners) {
  ++faces_;
  if (corners >= 3) ++(corners == 3 ? polygons_.triangles : corners == 4 ? polygons_.quads : polygons_.larger);
}

void MeshBuilder::addPolygon(const std::vector<std::int64_t>& corners, std::int64_t line) {
  const auto isLost = [&](std::int64_t corner) { return corner < 0 || corner >= vertexCount(); };
  const auto lost = std::find_if(corners.begin(), corners.end(), isLost);
  if (lost != corners.end()) noteLost(*lost, line);
  count(corners.size());
  if (lost != corners.end()) return;
  for (std::size_t i = 2; i < corners.size(); ++i) addTriangle(corners[0], corners[i - 1], corners[i]);
}

void MeshBuilder::addTriangle(std::int64_t a, std::int64_t b, std::int64_t c) {
  if (a == b || b == c || c == a) return;
  for (const std::int64_t corner : {a, b, c}) corners_.push_back(static_cast<int>(corner));
}

void MeshBuilder::noteLost(std::int64_t corner, std::int64_t line) {
  if (lost_++ > 0) return;
  lostCorner_ = corner;
  lostFace_ = faces_ + 1;
  lostLine_ = line;
}

std::optional<MeshFault> MeshBuilder::finish(MeshText& read) const {
  const std::string vertices = vertexCount() == 1 ? "1 vertex" : std::to_string(vertexCount()) + " vertices";
  if (lost_ > 0)
    return MeshFault{lostLine_,
                     (lostLine_ > 0 ? std::string() : "face " + std::to_string(lostFace_) + ": ") +
                         "a face has the corner " + std::to_string(lostCorner_) + ", but there are " + vertices +
                         (lost_ > 1 ? " (" + std::to_string(lost_) + " faces are like that)" : "") + exportMeshAgain};
  if (vertexCount() > std::numeric_limits<int>::max())
    return MeshFault{0, "there are " + vertices + ", more than this program holds; export a coarser scan"};
  const auto triangles = static_cast<Eigen::Index>(corners_.size() / 3);
  read.mesh.vertices = Eigen::Map<const TriangleMesh::Vertices>(places_.data(), vertexCount(), 3);
  read.mesh.triangles = Eigen::Map<const TriangleMesh::Triangles>(corners_.data(), triangles, 3);
  read.polygons = polygons_;
  return std::nullopt;
}

}  // namespace mien
