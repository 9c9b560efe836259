#include "ActionFit.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double lambda = 1e-4;
constexpr int mostSweeps = 20000;
constexpr double smallestChange = 1e-9;  // of a strength, in a sweep

/// Minimises x^T N x / 2 - b^T x for 0 <= x <= 1, coordinate after coordinate; N is positive definite, so this converges
/// to the one minimum.
Eigen::VectorXd minimise(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(right.size());
  Eigen::VectorXd slope = -right;
  for (int sweep = 0; sweep < mostSweeps; ++sweep) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double moved = std::clamp(x(i) - slope(i) / normal(i, i), 0.0, 1.0);
      const double change = moved - x(i);
      if (change == 0.0) continue;
      x(i) = moved;
      slope += change * normal.col(i);
      largest = std::max(largest, std::abs(change));
    }
    if (largest < smallestChange) break;
  }
  return x;
}

}  // namespace

ActionFit::ActionFit(const std::vector<FacialAction>& actions, const FAPMask& used)
    : matrix_(Eigen::MatrixXd::Zero(FAPFrame::count, static_cast<Eigen::Index>(actions.size()))) {
  for (std::size_t i = 0; i < actions.size(); ++i)
    for (const auto& [fap, value] : actions[i].faps)
      if (used[fap - 1]) matrix_(fap - 1, static_cast<Eigen::Index>(i)) = value;
  scale_ = matrix_.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index row = 0; row < matrix_.rows(); ++row)
    if (scale_(row) > 0.0) matrix_.row(row) /= scale_(row);
  normal_ = matrix_.transpose() * matrix_;
  normal_.diagonal().array() += lambda;
}

Eigen::VectorXd ActionFit::scaled(const FAPFrame& frame) const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(FAPFrame::count);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (moves(fap)) values(fap - 1) = frame.value(fap) / scale_(fap - 1);
  return values;
}

Eigen::VectorXd ActionFit::solve(const FAPFrame& frame) const {
  return minimise(normal_, matrix_.transpose() * scaled(frame));
}

FAPFrame ActionFit::framesOf(const Eigen::VectorXd& strengths) const {
  const Eigen::VectorXd values = (matrix_ * strengths).cwiseProduct(scale_);
  FAPFrame frame;
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap) frame.setValue(fap, values(fap - 1));
  return frame;
}

double ActionFit::loss(const FAPFrame& frame, const Eigen::VectorXd& strengths) const {
  return (matrix_ * strengths - scaled(frame)).squaredNorm();
}

}  // namespace mien
