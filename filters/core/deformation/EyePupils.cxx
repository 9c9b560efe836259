#include "EyePupils.h"

#include <map>
#include <numeric>

namespace mien {

namespace {

/// The connected part of the mesh that each vertex belongs to, named by one of its vertices.
std::vector<int> partsOf(std::size_t count, const MeshEdges& edges) {
  std::vector<int> part(count);
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int vertex) {
    while (part[vertex] != vertex) vertex = part[vertex] = part[part[vertex]];
    return vertex;
  };
  for (const auto& edge : edges) part[root(edge[0])] = root(edge[1]);
  for (std::size_t i = 0; i < count; ++i) part[i] = root(static_cast<int>(i));
  return part;
}

struct Part {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;

  Eigen::Vector3d middle() const { return sum / count; }
};

Eigen::Vector3d pupil(const std::map<int, Part>& parts, const Eigen::Vector3d& eye, double width) {
  const Part* best = nullptr;
  for (const auto& [name, part] : parts)
    if ((part.middle() - eye).norm() < width && (!best || part.count > best->count)) best = &part;
  return best ? best->middle() : eye;
}

}  // namespace

EyePupils eyePupils(const MeshVertices& vertices, const MeshEdges& edges, const LandmarkVertices& landmarks) {
  const std::vector<int> names = partsOf(vertices.rows(), edges);
  std::map<int, Part> parts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    parts[names[i]].sum += vertices.row(i).transpose();
    ++parts[names[i]].count;
  }
  for (const int landmark : landmarks) parts.erase(names[landmark]);
  const auto eye = [&](int first) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int i = first; i < first + 6; ++i) middle += vertices.row(landmarks[i]).transpose() / 6.0;
    return pupil(parts, middle, (vertices.row(landmarks[first]) - vertices.row(landmarks[first + 3])).norm());
  };
  return {eye(42), eye(36)};
}

}  // namespace mien
