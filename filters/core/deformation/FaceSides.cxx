#include "FaceSides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "NumberText.h"
#include "SmoothStep.h"

namespace mien {

namespace {

constexpr double unreachable = std::numeric_limits<double>::infinity();

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

/// Dijkstra's shortest paths along edges, up to a length.
std::vector<double> distancesFrom(const std::vector<int>& seeds, double longest, const MeshVertices& vertices,
                                  const Neighbours& neighbours) {
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
      if (next < distances[other] && next <= longest) queue.push({distances[other] = next, other});
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

std::vector<double> slitSides(const MeshVertices& vertices, const MeshEdges& edges, const MeshSlit& slit) {
  const Neighbours neighbours(vertices.rows(), edges);
  const std::vector<double> toUpper = distancesFrom(slit.upper, slit.reach + slit.halfWidth, vertices, neighbours);
  const std::vector<double> toLower = distancesFrom(slit.lower, slit.reach + slit.halfWidth, vertices, neighbours);
  std::vector<double> sides(vertices.rows(), 0.0);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double nearer = std::min(toUpper[i], toLower[i]);
    if (nearer >= slit.reach) continue;
    // Distances end at reach + half width: what is further away on the other side is wholly on this one.
    const double difference = std::isfinite(toUpper[i]) && std::isfinite(toLower[i]) ? toLower[i] - toUpper[i]
                              : std::isfinite(toUpper[i])                            ? slit.halfWidth
                                                                                     : -slit.halfWidth;
    sides[i] = std::clamp(difference / slit.halfWidth, -1.0, 1.0) * smoothStep(1.0 - nearer / slit.reach);
  }
  return sides;
}

std::vector<FaceSide> faceSides(const MeshVertices& vertices, const MeshEdges& edges, const LandmarkVertices& landmarks,
                                const FacialRegions& regions, double unit, const Progress& progress) {
  const auto sidesOf = [&](const std::vector<int>& upper, const std::vector<int>& lower, int begin, int end,
                           double reach) {
    MeshSlit slit;
    for (const int i : upper) slit.upper.push_back(landmarks[i]);
    for (const int i : lower) slit.lower.push_back(landmarks[i]);
    slit.halfWidth =
        std::max(0.5 * (vertices.row(landmarks[end]) - vertices.row(landmarks[begin])).norm(), 1e-3 * unit);
    slit.reach = reach * unit;
    return slitSides(vertices, edges, slit);
  };
  std::vector<FaceSide> sides(vertices.rows());
  if (!goesOn(progress, 0.0)) return sides;
  const auto lips = sidesOf({61, 62, 63}, {65, 66, 67}, 60, 64, regions.lipReach());
  if (!goesOn(progress, 0.4)) return sides;
  const auto right = sidesOf({37, 38}, {40, 41}, 36, 39, regions.lidReach());
  if (!goesOn(progress, 0.7)) return sides;
  const auto left = sidesOf({43, 44}, {46, 47}, 42, 45, regions.lidReach());
  for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = {lips[i], std::clamp(right[i] + left[i], -1.0, 1.0)};
  return sides;
}

int landmarkNumber(const std::string& name) {
  constexpr std::string_view prefix = "landmark";
  if (name.rfind(prefix, 0) != 0) return -1;
  const auto number = parseWholeNumber(std::string_view(name).substr(prefix.size()));
  return number && *number >= 0 && *number < 68 ? static_cast<int>(*number) : -1;
}

FaceSide landmarkSide(int landmark) {
  const auto within = [&](int first, int last) { return landmark >= first && landmark <= last; };
  if (within(49, 53) || within(61, 63)) return {1.0, 0.0};
  if (within(55, 59) || within(65, 67)) return {-1.0, 0.0};
  if (within(37, 38) || within(43, 44)) return {0.0, 1.0};
  return {0.0, within(40, 41) || within(46, 47) ? -1.0 : 0.0};
}

}  // namespace mien
