#include "ModeOperator.h"

#include <Eigen/LU>

#include <cmath>

namespace mien {

ModeOperator::ModeOperator(double rate, const std::vector<Condition>& conditions, double begin, double end)
    : begin_(begin), length_(end - begin), basis_(rate * (end - begin), static_cast<int>(conditions.size())) {
  const int n = basis_.order();
  ExtendedMatrix system(n, n);
  ExtendedRow scale(n);
  for (int i = 0; i < n; ++i) {
    const Condition& condition = conditions[i];
    const Extended u = (static_cast<Extended>(condition.u) - begin_) / length_;
    const ExtendedRow row = basis_.row(u, condition.derivative) / std::pow(static_cast<Extended>(length_), condition.derivative);
    scale[i] = row.cwiseAbs().maxCoeff();
    system.row(i) = row / scale[i];
    isValue_.push_back(condition.derivative == 0);
  }
  const Eigen::FullPivLU<ExtendedMatrix> factors(system);
  solvable_ = scale.allFinite() && (scale.array() > 0).all() && factors.isInvertible();
  if (solvable_) coefficients_ = factors.inverse() * scale.cwiseInverse().asDiagonal();
}

Eigen::RowVectorXd ModeOperator::row(double u, int derivative) const {
  const Extended local = (static_cast<Extended>(u) - begin_) / length_;
  const Extended unit = std::pow(static_cast<Extended>(length_), derivative);
  return ((basis_.row(local, derivative) / unit) * coefficients_).cast<double>();
}

double ModeOperator::absoluteSum(double u) const {
  const Eigen::RowVectorXd values = row(u);
  double sum = 0.0;
  for (size_t i = 0; i < isValue_.size(); ++i)
    if (isValue_[i]) sum += std::abs(values[i]);
  return sum;
}

double ModeOperator::lebesgueConstant() const {
  constexpr int steps = 600;
  const double step = length_ / steps;
  int best = 0;
  double largest = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double sum = absoluteSum(begin_ + i * step);
    if (sum > largest) { largest = sum; best = i; }
  }
  for (int i = -20; i <= 20; ++i) {
    const double u = begin_ + (best + i / 20.0) * step;
    if (u >= begin_ && u <= begin_ + length_) largest = std::max(largest, absoluteSum(u));
  }
  return largest;
}

}  // namespace mien
