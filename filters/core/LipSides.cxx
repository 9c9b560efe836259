#include "LipSides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace mien {

namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();
using Vertices = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Neighbours of vertex i are targets[starts[i]] .. targets[starts[i + 1] - 1].
struct Neighbours {
  std::vector<int> starts, targets;

  Neighbours(std::size_t vertexCount, const MeshEdges& edges) : starts(vertexCount + 1, 0), targets(2 * edges.size()) {
    for (const auto& edge : edges)
      for (const int end : edge) ++starts[end + 1];
    for (std::size_t i = 0; i < vertexCount; ++i) starts[i + 1] += starts[i];
    std::vector<int> next(starts.begin(), starts.end() - 1);
    for (const auto& edge : edges) {
      targets[next[edge[0]]++] = edge[1];
      targets[next[edge[1]]++] = edge[0];
    }
  }
};

/// Dijkstra's shortest paths along edges.
std::vector<double> distancesFrom(const std::vector<int>& seeds, const Vertices& vertices, const Neighbours& neighbours) {
  using Entry = std::pair<double, int>;
  std::vector<double> distances(vertices.rows(), unreachable);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (const int seed : seeds) queue.push({distances[seed] = 0.0, seed});
  while (!queue.empty()) {
    const auto [distance, vertex] = queue.top();
    queue.pop();
    if (distance > distances[vertex]) continue;
    for (int i = neighbours.starts[vertex]; i < neighbours.starts[vertex + 1]; ++i) {
      const int other = neighbours.targets[i];
      const double next = distance + (vertices.row(other) - vertices.row(vertex)).norm();
      if (next < distances[other]) queue.push({distances[other] = next, other});
    }
  }
  return distances;
}

}  // namespace

MeshEdges edgesOf(const TriangleMesh& mesh) {
  MeshEdges edges;
  edges.reserve(3 * mesh.triangles.rows());
  for (Eigen::Index i = 0; i < mesh.triangles.rows(); ++i)
    for (int k = 0; k < 3; ++k) edges.push_back({mesh.triangles(i, k), mesh.triangles(i, (k + 1) % 3)});
  return edges;
}

std::vector<LipSide> lipSides(const Vertices& vertices, const MeshEdges& edges, const std::vector<int>& upper,
                              const std::vector<int>& lower, double halfWidth) {
  const Neighbours neighbours(vertices.rows(), edges);
  const std::vector<double> toUpper = distancesFrom(upper, vertices, neighbours);
  const std::vector<double> toLower = distancesFrom(lower, vertices, neighbours);
  std::vector<LipSide> sides(vertices.rows(), 0.0);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (std::isfinite(toUpper[i]) && std::isfinite(toLower[i]))
      sides[i] = std::clamp((toLower[i] - toUpper[i]) / halfWidth, -1.0, 1.0);
  return sides;
}

}  // namespace mien
