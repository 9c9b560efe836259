#include "MeshCleaning.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

#include "EdgeRings.h"
#include "JoinedSets.h"

namespace mien {

namespace {

Eigen::Vector3d areaVector(const TriangleMesh& mesh, const Eigen::Vector3i& t) {
  const Eigen::Vector3d a = mesh.vertices.row(t[0]), b = mesh.vertices.row(t[1]), c = mesh.vertices.row(t[2]);
  return 0.5 * (b - a).cross(c - a);
}

std::array<int, 3> sortedCorners(const Eigen::Vector3i& t) {
  std::array<int, 3> corners = {t[0], t[1], t[2]};
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Which triangles are the first of those with the same corners.
std::vector<bool> firstOfTwins(const std::vector<Eigen::Vector3i>& triangles) {
  std::vector<int> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<std::array<int, 3>> keys(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) keys[i] = sortedCorners(triangles[i]);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
  std::vector<bool> first(triangles.size(), true);
  for (size_t i = 1; i < order.size(); ++i)
    if (keys[order[i]] == keys[order[i - 1]]) first[order[i]] = false;
  return first;
}

/// Sums up the parts in the order in which they first occur.
MeshParts measuredParts(const TriangleMesh& mesh) {
  JoinedSets sets(static_cast<size_t>(mesh.vertices.rows()));
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int i = 1; i < 3; ++i) sets.join(mesh.triangles(t, 0), mesh.triangles(t, i));
  MeshParts parts;
  std::vector<int> partOfRoot(static_cast<size_t>(mesh.vertices.rows()), -1);
  std::vector<Eigen::AlignedBox3d> boxes;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    int& part = partOfRoot[sets.find(mesh.triangles(t, 0))];
    if (part < 0) {
      part = parts.count();
      parts.area.push_back(0.0);
      boxes.emplace_back();
    }
    parts.ofTriangle.push_back(part);
    parts.area[part] += areaVector(mesh, mesh.triangles.row(t)).norm();
    for (int i = 0; i < 3; ++i) boxes[part].extend(Eigen::Vector3d(mesh.vertices.row(mesh.triangles(t, i))));
  }
  for (const Eigen::AlignedBox3d& box : boxes) {
    parts.middle.push_back(box.center());
    parts.size.push_back(box.diagonal().norm());
  }
  return parts;
}

}  // namespace

TriangleMesh withTriangles(const TriangleMesh::Vertices& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  std::vector<int> number(static_cast<size_t>(vertices.rows()), -1);
  for (const Eigen::Vector3i& t : triangles)
    for (int i = 0; i < 3; ++i) number[t[i]] = 0;
  int used = 0;
  for (int& n : number)
    if (n == 0) n = used++;
  TriangleMesh mesh;
  mesh.vertices.resize(used, 3);
  for (int i = 0; i < vertices.rows(); ++i)
    if (number[i] >= 0) mesh.vertices.row(number[i]) = vertices.row(i);
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) mesh.triangles(static_cast<Eigen::Index>(t), i) = number[triangles[t][i]];
  return mesh;
}

CleanMesh cleaned(const TriangleMesh& mesh) {
  CleanMesh result;
  const std::vector<int> first = firstAtPlace(mesh.vertices);
  for (size_t i = 0; i < first.size(); ++i) result.mergedVertices += first[i] != static_cast<int>(i);
  std::vector<Eigen::Vector3i> sound;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3i corners(first[mesh.triangles(t, 0)], first[mesh.triangles(t, 1)],
                                  first[mesh.triangles(t, 2)]);
    if (areaVector(mesh, corners).squaredNorm() > 0.0) sound.push_back(corners);
  }
  const std::vector<bool> kept = firstOfTwins(sound);
  std::vector<Eigen::Vector3i> triangles;
  for (size_t t = 0; t < sound.size(); ++t)
    if (kept[t]) triangles.push_back(sound[t]);
  result.degenerateTriangles = static_cast<int>(mesh.triangles.rows()) - static_cast<int>(triangles.size());
  result.mesh = withTriangles(mesh.vertices, triangles);
  return result;
}

MeshParts partsOf(const TriangleMesh& mesh) {
  const MeshParts found = measuredParts(mesh);
  std::vector<int> order(found.area.size()), place(found.area.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return found.area[a] > found.area[b]; });
  MeshParts parts;
  for (size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = static_cast<int>(i);
    parts.area.push_back(found.area[order[i]]);
    parts.middle.push_back(found.middle[order[i]]);
    parts.size.push_back(found.size[order[i]]);
  }
  for (const int part : found.ofTriangle) parts.ofTriangle.push_back(place[part]);
  return parts;
}

TriangleMesh withParts(const TriangleMesh& mesh, const MeshParts& parts, const std::vector<bool>& wanted) {
  std::vector<Eigen::Vector3i> triangles;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    if (wanted[parts.ofTriangle[t]]) triangles.push_back(mesh.triangles.row(t));
  return withTriangles(mesh.vertices, triangles);
}

int boundaryLoops(const TriangleMesh& mesh) {
  const EdgeRings rings(mesh);
  JoinedSets sets(static_cast<size_t>(mesh.vertices.rows()));
  std::vector<int> ends;
  for (int t = 0; t < mesh.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (!rings.isRim(3 * t + i)) continue;
      ends.push_back(rings.first(mesh.triangles(t, i)));
      sets.join(ends.back(), rings.first(mesh.triangles(t, (i + 1) % 3)));
    }
  for (int& end : ends) end = sets.find(end);
  std::sort(ends.begin(), ends.end());
  return static_cast<int>(std::unique(ends.begin(), ends.end()) - ends.begin());
}

double signedVolume(const TriangleMesh& mesh) {
  const Eigen::RowVector3d middle = mesh.vertices.colwise().mean();
  double volume = 0.0;
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::RowVector3d area = areaVector(mesh, mesh.triangles.row(t)).transpose();
    volume += area.dot(mesh.vertices.row(mesh.triangles(t, 0)) - middle) / 3.0;
  }
  return volume;
}

TriangleMesh::Vertices outwardNormals(const TriangleMesh& mesh) {
  TriangleMesh::Vertices normals = TriangleMesh::Vertices::Zero(mesh.vertices.rows(), 3);
  for (int t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::RowVector3d area = areaVector(mesh, mesh.triangles.row(t)).transpose();
    for (int i = 0; i < 3; ++i) normals.row(mesh.triangles(t, i)) += area;
  }
  if (signedVolume(mesh) < 0.0) normals = -normals;
  for (int i = 0; i < normals.rows(); ++i) normals.row(i).stableNormalize();
  return normals;
}

}  // namespace mien
