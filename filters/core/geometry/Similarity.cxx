#include "Similarity.h"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace mien {

Similarity fitSimilarity(const Similarity::Points& from, const Similarity::Points& to, const Eigen::VectorXd& weights,
                         bool rigid) {
  Similarity fit;
  const double sum = weights.sum();
  if (!(sum > 0.0)) return fit;
  const Eigen::RowVector3d start = weights.transpose() * from / sum, end = weights.transpose() * to / sum;
  const Similarity::Points a = from.rowwise() - start, b = to.rowwise() - end;
  const Eigen::Matrix3d covariance = a.transpose() * weights.asDiagonal() * b;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1.0, 1.0, 1.0);
  if ((svd.matrixV() * svd.matrixU().transpose()).determinant() < 0.0) signs.z() = -1.0;
  fit.rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
  const double spread = weights.dot(a.rowwise().squaredNorm());
  if (!rigid && spread > 0.0) fit.scale = svd.singularValues().dot(signs) / spread;
  fit.translation = end.transpose() - fit.scale * (fit.rotation * start.transpose());
  return fit;
}

}  // namespace mien
