#include "FaceRegistration.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "SkinMatches.h"
#include "SmoothAlignment.h"

namespace mien {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Points = TriangleMesh::Vertices;

/// From a plate that keeps its shape to one that follows lids and lips.
constexpr std::array<double, 9> stiffness = {300.0, 100.0, 30.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.5};
constexpr double alignmentShare = 0.3;                // of the time
constexpr double firstReach = 15.0, lastReach = 4.0;  // mm at which skin is looked for

/// The Laplacian over the grid; every row sums to zero, weights fall with the distance of the neighbours.
Sparse gridLaplacian(const FaceTemplate& face) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int r = 0; r < face.rows; ++r)
    for (int c = 0; c < face.columns; ++c) {
      const int i = face.index(r, c);
      std::vector<std::pair<int, double>> neighbours;
      double sum = 0.0;
      for (const auto& [dr, dc] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
        if (r + dr < 0 || r + dr >= face.rows || c + dc < 0 || c + dc >= face.columns) continue;
        const int j = face.index(r + dr, c + dc);
        const double length = (face.mesh.vertices.row(i) - face.mesh.vertices.row(j)).norm();
        neighbours.emplace_back(j, 1.0 / std::max(length, 0.3));
        sum += neighbours.back().second;
      }
      for (const auto& [j, weight] : neighbours) entries.emplace_back(i, j, -weight / sum);
      entries.emplace_back(i, i, 1.0);
    }
  Sparse laplacian(face.rows * face.columns, face.rows * face.columns);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

/// What each point of the grid is drawn to, and how strongly.
struct Pull {
  Points target;
  Eigen::VectorXd weight;
  double squares = 0.0;
  int found = 0;
};

Pull pullOf(const TriangleMesh& moved, const SkinMatches& skin, double reach) {
  Pull pull{moved.vertices, Eigen::VectorXd::Zero(moved.vertices.rows())};
  const std::vector<SkinMatch> matches = skin.of(moved, reach);
  for (Eigen::Index i = 0; i < moved.vertices.rows(); ++i) {
    const SkinMatch& match = matches[i];
    if (match.skin < 0) continue;
    // along the skin the point is free: only its distance from the tangent plane counts
    pull.target.row(i) += match.gap * skin.normals().row(match.skin);
    pull.weight[i] = match.weight;
    pull.squares += match.gap * match.gap;
    ++pull.found;
  }
  return pull;
}

}  // namespace

std::string registerFace(const FaceTemplate& face, const Similarity& faceToScan, const TriangleMesh& mesh,
                         FaceRegistration& registration, const Progress& progress) {
  const SkinMatches skin(mesh);
  const Sparse laplacian = gridLaplacian(face);
  const Sparse plate = laplacian.transpose() * laplacian;
  TriangleMesh moved{faceToScan.applied(face.mesh.vertices), face.mesh.triangles};
  if (!alignSmoothly(face, skin, moved, firstReach, partOf(progress, 0.0, alignmentShare))) return "stopped";
  const Points start = moved.vertices;
  Eigen::SimplicialLDLT<Sparse> solver;
  constexpr int stepsPerStiffness = 3;
  const int steps = stepsPerStiffness * static_cast<int>(stiffness.size());
  const Progress bending = partOf(progress, alignmentShare, 1.0);
  for (int step = 0; step < steps; ++step) {
    if (!goesOn(bending, static_cast<double>(step) / steps)) return "stopped";
    const double reach = firstReach + (lastReach - firstReach) * step / (steps - 1);
    const Pull pull = pullOf(moved, skin, reach);
    Sparse system = stiffness[step / stepsPerStiffness] * plate;
    for (Eigen::Index i = 0; i < pull.weight.size(); ++i) system.coeffRef(i, i) += pull.weight[i] + 1e-4;
    if (step == 0) solver.analyzePattern(system);
    solver.factorize(system);
    const Points displacement =
        solver.solve(pull.weight.asDiagonal() * (pull.target - start) + 1e-4 * (moved.vertices - start));
    moved.vertices = start + displacement;
  }
  const Pull rest = pullOf(moved, skin, lastReach);
  registration = {moved.vertices, std::sqrt(rest.squares / std::max(1, rest.found)),
                  static_cast<double>(rest.found) / static_cast<double>(face.mesh.vertices.rows())};
  return {};
}

}  // namespace mien
