#include "SurfaceContour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace mien {

namespace {

using Points = ClosedCurves::Points;
using Edge = std::pair<int, int>;

Edge edgeOf(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

struct EdgeHash {
  size_t operator()(const Edge& edge) const {
    return std::hash<std::uint64_t>()(static_cast<std::uint64_t>(edge.first) << 32 |
                                      static_cast<unsigned>(edge.second));
  }
};

/// The points at which edges are crossed, each once.
class Crossings {
 public:
  Crossings(const TriangleMesh& mesh, const Points& normals, const Eigen::VectorXd& facing)
      : mesh_(mesh), normals_(normals), facing_(facing) {}

  int at(int a, int b) {
    const auto [found, isNew] = known_.emplace(edgeOf(a, b), static_cast<int>(points.size()));
    if (!isNew) return found->second;
    const double share = facing_[a] / (facing_[a] - facing_[b]);
    points.push_back((1.0 - share) * mesh_.vertices.row(a) + share * mesh_.vertices.row(b));
    normals.push_back(((1.0 - share) * normals_.row(a) + share * normals_.row(b)).normalized());
    return found->second;
  }

  std::vector<Eigen::RowVector3d> points, normals;

 private:
  const TriangleMesh& mesh_;
  const Points& normals_;
  const Eigen::VectorXd& facing_;
  std::unordered_map<Edge, int, EdgeHash> known_;
};

/// The lines through numbered points.
template <class GetPoint, class GetNormal, class GetInward>
std::vector<ContourLine> linesThrough(const std::vector<Edge>& pieces, const GetPoint& point, const GetNormal& normal,
                                      const GetInward& inward) {
  std::vector<ContourLine> lines;
  for (const std::vector<int>& numbers : joinedPieces(pieces)) {
    ContourLine line{Points(numbers.size(), 3), Points(numbers.size(), 3), Points(numbers.size(), 3)};
    for (size_t i = 0; i < numbers.size(); ++i) {
      line.points.row(i) = point(numbers[i]);
      line.normals.row(i) = normal(numbers[i]);
      line.inwards.row(i) = inward(numbers[i]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Walks over pieces that were not used yet, from a point as far as they lead.
class PieceWalk {
 public:
  explicit PieceWalk(const std::vector<Edge>& pieces) : pieces_(pieces), used_(pieces.size(), false) {
    for (size_t i = 0; i < pieces.size(); ++i)
      for (const int end : {pieces[i].first, pieces[i].second}) at_[end].push_back(static_cast<int>(i));
  }

  std::vector<int> from(int point) {
    std::vector<int> line = {point};
    for (int piece = next(point); piece >= 0; piece = next(line.back())) {
      used_[piece] = true;
      line.push_back(pieces_[piece].first == line.back() ? pieces_[piece].second : pieces_[piece].first);
    }
    return line;
  }

  bool isUsed(size_t piece) const { return used_[piece]; }
  bool isEnd(int point) const { return at_.at(point).size() % 2 == 1; }

 private:
  int next(int point) const {
    for (const int piece : at_.at(point))
      if (!used_[piece]) return piece;
    return -1;
  }

  const std::vector<Edge>& pieces_;
  std::vector<bool> used_;
  std::map<int, std::vector<int>> at_;
};

}  // namespace

std::vector<std::vector<int>> joinedPieces(const std::vector<Edge>& pieces) {
  PieceWalk walk(pieces);
  std::vector<std::vector<int>> lines;
  for (const bool openOnly : {true, false})  // open lines first: from their ends they come out whole
    for (size_t i = 0; i < pieces.size(); ++i)
      for (const int end : {pieces[i].first, pieces[i].second})
        if (!walk.isUsed(i) && (!openOnly || walk.isEnd(end))) lines.push_back(walk.from(end));
  return lines;
}

std::vector<ContourLine> silhouettes(const TriangleMesh& mesh, const Points& normals, const PicturePlane& plane) {
  const Eigen::VectorXd facing = normals * plane.out;
  Crossings crossings(mesh, normals, facing);
  std::vector<Edge> pieces;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    std::vector<int> ends;
    for (int corner = 0; corner < 3; ++corner) {
      const int a = mesh.triangles(t, corner), b = mesh.triangles(t, (corner + 1) % 3);
      if ((facing[a] >= 0.0) != (facing[b] >= 0.0)) ends.push_back(crossings.at(a, b));
    }
    if (ends.size() == 2) pieces.emplace_back(ends[0], ends[1]);
  }
  return linesThrough(
      pieces, [&](int i) { return crossings.points[i]; }, [&](int i) { return crossings.normals[i]; },
      [&](int i) -> Eigen::RowVector3d { return -crossings.normals[i]; });
}

std::vector<ContourLine> borders(const TriangleMesh& mesh, const Points& normals) {
  struct Side {
    int triangles = 0, opposite = 0;
  };
  std::map<Edge, Side> sides;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      Side& side = sides[edgeOf(mesh.triangles(t, corner), mesh.triangles(t, (corner + 1) % 3))];
      ++side.triangles;
      side.opposite = mesh.triangles(t, (corner + 2) % 3);
    }
  std::vector<Edge> pieces;
  std::map<int, Eigen::RowVector3d> inwards;
  for (const auto& [edge, side] : sides) {
    if (side.triangles != 1) continue;
    pieces.push_back(edge);
    const Eigen::RowVector3d a = mesh.vertices.row(edge.first), along = mesh.vertices.row(edge.second) - a;
    const Eigen::RowVector3d across = mesh.vertices.row(side.opposite) - a;
    const Eigen::RowVector3d inward = across - across.dot(along) / std::max(along.squaredNorm(), 1e-300) * along;
    for (const int end : {edge.first, edge.second})
      inwards.emplace(end, Eigen::RowVector3d::Zero()).first->second += inward;
  }
  return linesThrough(
      pieces, [&](int i) { return mesh.vertices.row(i); }, [&](int i) { return normals.row(i); },
      [&](int i) { return inwards.at(i); });
}

Points vertexNormals(const TriangleMesh& mesh) {
  Points normals = Points::Zero(mesh.vertices.rows(), 3);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int i) -> Eigen::RowVector3d { return mesh.vertices.row(mesh.triangles(t, i)); };
    const Eigen::RowVector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    for (int i = 0; i < 3; ++i) normals.row(mesh.triangles(t, i)) += normal;
  }
  normals.rowwise().normalize();
  return normals;
}

}  // namespace mien
