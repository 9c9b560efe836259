#include "RigidMotion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <vector>

namespace mien {

namespace {

constexpr double stillShare = 0.25;  // of the points, at least
constexpr double leastScale = 1e-9;  // of the extent: distances below are rounding
constexpr double converged = 1e-12;  // of the extent
constexpr int mostRounds = 100;

using Points = ClosedCurves::Points;

/// Least squares with weights.
RigidMotion weightedFit(const Points& from, const Points& to, const Eigen::VectorXd& weights) {
  const double sum = weights.sum();
  const Eigen::RowVector3d start = weights.transpose() * from / sum, end = weights.transpose() * to / sum;
  const Eigen::Matrix3d covariance = (from.rowwise() - start).transpose() * weights.asDiagonal() * (to.rowwise() - end);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  signs.z() = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  RigidMotion motion;
  motion.rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
  motion.translation = end.transpose() - motion.rotation * start.transpose();
  return motion;
}

Eigen::VectorXd distances(const Points& from, const Points& to, const RigidMotion& motion) {
  return (motion.undone(to) - from).rowwise().norm();
}

/// The distance that the stillest quarter of the points keep.
double stillDistance(const Eigen::VectorXd& distances) {
  std::vector<double> sorted(distances.data(), distances.data() + distances.size());
  const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(stillShare * (sorted.size() - 1));
  std::nth_element(sorted.begin(), place, sorted.end());
  return *place;
}

RigidMotion reweighted(const Points& from, const Points& to, RigidMotion motion, double extent) {
  for (int round = 0; round < mostRounds; ++round) {
    const Eigen::VectorXd far = distances(from, to, motion);
    const double scale = std::max(stillDistance(far), leastScale * extent);
    const Eigen::VectorXd weights = (1.0 + (far.array() / scale).square()).square().inverse();
    const RigidMotion next = weightedFit(from, to, weights);
    const double change = (next.undone(to) - motion.undone(to)).rowwise().norm().maxCoeff();
    motion = next;
    if (change <= converged * extent) break;
  }
  return motion;
}

}  // namespace

ClosedCurves::Points RigidMotion::undone(const ClosedCurves::Points& moved) const {
  // Rows are transposed points: (R^T (p - t))^T = (p - t)^T R.
  return (moved.rowwise() - translation.transpose()) * rotation;
}

double RigidMotion::angle() const {
  return Eigen::AngleAxisd(rotation).angle();
}

RigidMotion fitRigidMotion(const ClosedCurves::Points& from, const ClosedCurves::Points& to) {
  return from.rows() == 0 ? RigidMotion() : weightedFit(from, to, Eigen::VectorXd::Ones(from.rows()));
}

RigidMotion fitStillPart(const ClosedCurves::Points& from, const ClosedCurves::Points& to) {
  if (from.rows() == 0) return {};
  const double extent = (from.colwise().maxCoeff() - from.colwise().minCoeff()).norm();
  const RigidMotion still = reweighted(from, to, RigidMotion(), extent);
  const RigidMotion moved = reweighted(from, to, fitRigidMotion(from, to), extent);
  const double stillFar = stillDistance(distances(from, to, still));
  return stillDistance(distances(from, to, moved)) < stillFar - leastScale * extent ? moved : still;
}

}  // namespace mien
