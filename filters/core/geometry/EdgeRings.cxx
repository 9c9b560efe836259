#include "EdgeRings.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace mien {

namespace {

struct Side {
  int low, high, number;

  bool along(const Side& other) const { return low == other.low && high == other.high; }
  bool operator<(const Side& other) const {
    return std::array{low, high, number} < std::array{other.low, other.high, other.number};
  }
};

std::vector<Side> sortedSides(const TriangleMesh& mesh, const std::vector<int>& first) {
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(mesh.triangles.rows()));
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const int corners[3] = {first[mesh.triangles(t, 0)], first[mesh.triangles(t, 1)], first[mesh.triangles(t, 2)]};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (int i = 0; i < 3; ++i) {
      const int a = corners[i], b = corners[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), 3 * t + i});
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::vector<int> firstAtPlace(const TriangleMesh::Vertices& vertices) {
  std::vector<int> order(static_cast<std::size_t>(vertices.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int i) { return std::array<double, 3>{vertices(i, 0), vertices(i, 1), vertices(i, 2)}; };
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto p = place(a), q = place(b);
    return p != q ? p < q : a < b;
  });
  std::vector<int> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && place(order[i]) == place(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

EdgeRings::EdgeRings(const TriangleMesh& mesh)
    : first_(firstAtPlace(mesh.vertices)),
      next_(3 * static_cast<std::size_t>(mesh.triangles.rows()), -1),
      rimCorner_(first_.size(), false) {
  const std::vector<Side> sides = sortedSides(mesh, first_);
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].along(sides[begin])) ++end;
    for (std::size_t i = begin; i < end; ++i) next_[sides[i].number] = sides[i + 1 < end ? i + 1 : begin].number;
    if (end == begin + 1) rimCorner_[sides[begin].low] = rimCorner_[sides[begin].high] = true;
    begin = end;
  }
}

}  // namespace mien
