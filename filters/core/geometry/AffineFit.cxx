#include "AffineFit.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

namespace mien {

AffineFit::AffineFit(const Points& from, const Points& to) {
  if (from.rows() < 3) return;
  const Eigen::RowVector2d middle = from.colwise().mean(), middleTo = to.colwise().mean();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(from.rowwise() - middle);
  linear_ = solver.solve(to.rowwise() - middleTo).transpose();
  shift_ = middleTo.transpose() - linear_ * middle.transpose();
  sound_ = solver.rank() == 2 && linear_.allFinite() && shift_.allFinite();
}

double AffineFit::scale() const {
  return std::sqrt(std::abs(linear_.determinant()));
}

}  // namespace mien
