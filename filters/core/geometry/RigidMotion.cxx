#include "RigidMotion.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace mien {

ClosedCurves::Points RigidMotion::undone(const ClosedCurves::Points& moved) const {
  // Rows are transposed points: (R^T (p - t))^T = (p - t)^T R.
  return (moved.rowwise() - translation.transpose()) * rotation;
}

double RigidMotion::angle() const {
  return Eigen::AngleAxisd(rotation).angle();
}

RigidMotion fitRigidMotion(const ClosedCurves::Points& from, const ClosedCurves::Points& to) {
  RigidMotion motion;
  if (from.rows() == 0) return motion;
  const Eigen::RowVector3d start = from.colwise().mean(), end = to.colwise().mean();
  const Eigen::Matrix3d covariance = (from.rowwise() - start).transpose() * (to.rowwise() - end);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  signs.z() = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  motion.rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
  motion.translation = end.transpose() - motion.rotation * start.transpose();
  return motion;
}

}  // namespace mien
