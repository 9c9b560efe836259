#include "SmoothWarp.h"

#include <Eigen/LU>
#include <cmath>

namespace mien {

SmoothWarp::SmoothWarp(const Points& from, const Points& to, double softness) : middle_(from.colwise().mean()) {
  const Eigen::Index n = from.rows(), d = from.cols();
  from_ = from.rowwise() - middle_.transpose();
  scale_ = from_.rowwise().norm().mean();
  from_ /= scale_;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + d + 1, n + d + 1);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) system(i, j) = radial((from_.row(i) - from_.row(j)).norm());
  // r is conditionally negative in space: smoothing has the sign of the kernel there.
  system.diagonal().head(n).array() += d == 2 ? softness : -softness;
  system.block(0, n, n, 1).setOnes();
  system.block(0, n + 1, n, d) = from_;
  system.bottomLeftCorner(d + 1, n) = system.topRightCorner(n, d + 1).transpose();
  Eigen::MatrixXd places = Eigen::MatrixXd::Zero(n + d + 1, d);
  places.topRows(n) = to;
  const Eigen::FullPivLU<Eigen::MatrixXd> solver(system);
  weights_ = solver.solve(places);
  sound_ = system.allFinite() && solver.isInvertible() && weights_.allFinite();
}

double SmoothWarp::radial(double r) const {
  if (from_.cols() == 3) return r;
  return r > 0.0 ? r * r * std::log(r) : 0.0;
}

Eigen::VectorXd SmoothWarp::operator()(const Eigen::VectorXd& place) const {
  const Eigen::Index n = from_.rows(), d = from_.cols();
  const Eigen::RowVectorXd p = (place - middle_).transpose() / scale_;
  Eigen::RowVectorXd image = weights_.row(n) + p * weights_.bottomRows(d);
  for (Eigen::Index i = 0; i < n; ++i) image += radial((p - from_.row(i)).norm()) * weights_.row(i);
  return image.transpose();
}

Eigen::MatrixXd SmoothWarp::derivative(const Eigen::VectorXd& place) const {
  const Eigen::Index n = from_.rows(), d = from_.cols();
  const Eigen::RowVectorXd p = (place - middle_).transpose() / scale_;
  Eigen::MatrixXd jacobian = weights_.bottomRows(d).transpose();
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::RowVectorXd way = p - from_.row(i);
    const double r = way.norm();
    if (r == 0.0) continue;
    const double slope = d == 3 ? 1.0 / r : 2.0 * std::log(r) + 1.0;  // of the radial function, over r
    jacobian += weights_.row(i).transpose() * (slope * way);
  }
  return jacobian / scale_;
}

}  // namespace mien
