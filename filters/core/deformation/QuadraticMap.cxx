#include "QuadraticMap.h"

namespace mien {

QuadraticMap::Coefficients QuadraticMap::identity() {
  Coefficients result = Coefficients::Zero();
  result(0, 3) = 1.0;
  result(1, 4) = 1.0;
  return result;
}

std::string coefficientName(int index) {
  return (index < 6 ? "a" : "b") + std::to_string(index % 6 + 1);
}

QuadraticMap::Basis QuadraticMap::basis(const Eigen::Vector2d& point) {
  const double x = point.x(), y = point.y();
  return (Basis() << x * x, x * y, y * y, x, y, 1.0).finished();
}

Eigen::Matrix2d QuadraticMap::jacobian(const Eigen::Vector2d& point) const {
  const double x = point.x(), y = point.y();
  Eigen::Matrix<double, 6, 2> derivatives;
  derivatives << 2.0 * x, 0.0, y, x, 0.0, 2.0 * y, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0;
  return coefficients * derivatives;
}

QuadraticMap QuadraticMap::mirrored() const {
  const Basis signs = (Basis() << 1.0, -1.0, 1.0, -1.0, 1.0, 1.0).finished();
  QuadraticMap result;
  result.coefficients.row(0) = -coefficients.row(0).cwiseProduct(signs.transpose());
  result.coefficients.row(1) = coefficients.row(1).cwiseProduct(signs.transpose());
  return result;
}

}  // namespace mien
