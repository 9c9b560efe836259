#include "SmoothAlignment.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace mien {

namespace {

using Points = TriangleMesh::Vertices;

constexpr int largestDegree = 3, steps = 20;
constexpr int thinning = 4;           // of the points, another fourth in each step
constexpr double size = 70.0;         // mm, half of a face
constexpr double spread = 3.0;        // mm at that distance, by which faces differ linearly; of degree d the d-th part
constexpr double freely = 20.0;       // mm; a shift
constexpr double misfit = 5.5;        // mm, of a point that only smooth bending has brought near
constexpr double alignedReach = 4.0;  // mm

/// The monomials up to a degree at each point of a face, and what is expected of their coefficients.
struct Basis {
  Eigen::MatrixXd values;  ///< points x monomials
  Eigen::VectorXd prior;   ///< misfit over expected size, squared

  explicit Basis(const Points& points) {
    const Points scaled = (points.rowwise() - points.colwise().mean()) / size;
    for (int d = 0; d <= largestDegree; ++d)
      for (int a = d; a >= 0; --a)
        for (int b = d - a; b >= 0; --b) add(scaled, a, b, d - a - b);
  }

 private:
  void add(const Points& p, int a, int b, int c) {
    const Eigen::Index k = values.cols();
    values.conservativeResize(p.rows(), k + 1);
    values.col(k) = p.col(0).array().pow(a) * p.col(1).array().pow(b) * p.col(2).array().pow(c);
    prior.conservativeResize(k + 1);
    const int d = a + b + c;
    prior[k] = std::pow(misfit / (d == 0 ? freely : spread / d), 2);
  }
};

/// The displacement of least misfit from the tangent planes that the points have met.
Points displacementTo(const SkinMatches& skin, const std::vector<SkinMatch>& matches, const Basis& basis,
                      const Points& start, int first) {
  const Eigen::Index m = basis.values.cols();
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(3 * m, 3 * m);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * m), row(3 * m);
  for (Eigen::Index i = first; i < start.rows(); i += thinning) {
    if (matches[i].skin < 0) continue;
    const Eigen::RowVector3d n = skin.normals().row(matches[i].skin);
    for (int c = 0; c < 3; ++c) row.segment(c * m, m) = n[c] * basis.values.row(i).transpose();
    const double weight = thinning * matches[i].weight;
    system.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right += weight * n.dot(skin.points().row(matches[i].skin) - start.row(i)) * row;
  }
  for (int c = 0; c < 3; ++c) system.diagonal().segment(c * m, m) += basis.prior;
  const Eigen::VectorXd coefficients = system.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  return basis.values * Eigen::Map<const Eigen::MatrixXd>(coefficients.data(), m, 3);
}

}  // namespace

bool alignSmoothly(const FaceTemplate& face, const SkinMatches& skin, TriangleMesh& moved, double reach,
                   const Progress& progress) {
  const Basis basis(face.mesh.vertices);  // in the frame of the face, so that the scan's pose does not matter
  const Points start = moved.vertices;
  for (int step = 0; step < steps; ++step) {
    if (!goesOn(progress, static_cast<double>(step) / steps)) return false;
    const double present = reach + (alignedReach - reach) * step / steps;
    moved.vertices = start + displacementTo(skin, skin.of(moved, present), basis, start, step % thinning);
  }
  return true;
}

}  // namespace mien
