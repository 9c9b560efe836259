#include "EyeShells.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "JoinedSets.h"

namespace mien {

namespace {

constexpr std::size_t fewest = 12;                           // vertices of a shell
constexpr double smallestRadius = 0.2, largestRadius = 0.8;  // pupil units; those of the reference heads are 0.45, 0.5
constexpr double beside = 0.35;                              // a centre from its pupil, pupil units
constexpr double roughness = 0.1;  // of the radius; those of the reference heads are 0.045, 0.04

struct ShellPart {
  std::vector<int> vertices;
  Eigen::AlignedBox3d box;
};

/// The sphere of least squares: |p|^2 = 2 c p + (r^2 - c^2), about the middle of the box.
bool isShell(const MeshVertices& vertices, const ShellPart& part) {
  if (part.vertices.size() < fewest || part.box.sizes().maxCoeff() > 2.5 * largestRadius) return false;
  const Eigen::Vector3d middle = part.box.center();
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const int i : part.vertices) {
    const Eigen::Vector3d p = vertices.row(i).transpose() - middle;
    const Eigen::Vector4d row(2.0 * p.x(), 2.0 * p.y(), 2.0 * p.z(), 1.0);
    normal += row * row.transpose();
    right += p.squaredNorm() * row;
  }
  const Eigen::Vector4d solution = normal.ldlt().solve(right);
  const Eigen::Vector3d centre = middle + solution.head<3>();
  const double radius = std::sqrt(solution[3] + solution.head<3>().squaredNorm());
  if (!(radius > smallestRadius && radius < largestRadius)) return false;
  if (!(std::hypot(std::abs(centre.x()) - 1.0, centre.y()) < beside)) return false;
  double squares = 0.0;
  for (const int i : part.vertices) squares += std::pow((vertices.row(i).transpose() - centre).norm() - radius, 2);
  return std::sqrt(squares / double(part.vertices.size())) < roughness * radius;
}

}  // namespace

std::vector<bool> eyeShells(const MeshVertices& vertices, const MeshEdges& edges) {
  JoinedSets sets(static_cast<std::size_t>(vertices.rows()));
  for (const auto& edge : edges) sets.join(edge[0], edge[1]);
  std::map<int, ShellPart> parts;
  for (Eigen::Index i = 0; i < vertices.rows(); ++i) {
    ShellPart& part = parts[sets.find(static_cast<int>(i))];
    part.vertices.push_back(static_cast<int>(i));
    part.box.extend(vertices.row(i).transpose());
  }
  std::vector<const ShellPart*> shells;
  for (const auto& [name, part] : parts)
    if (isShell(vertices, part)) shells.push_back(&part);
  std::vector<bool> inEyes(static_cast<std::size_t>(vertices.rows()), false);
  for (const auto& [name, part] : parts)
    for (const ShellPart* shell : shells)
      if (shell->box.contains(part.box))
        for (const int i : part.vertices) inEyes[i] = true;
  return inEyes;
}

}  // namespace mien
