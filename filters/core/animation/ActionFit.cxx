#include "ActionFit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double lambda = 1e-4;
constexpr double slopeTolerance = 1e-10;  // of a slope

/// Minimises x^T N x / 2 - b^T x for 0 <= x <= 1, N positive definite, by sets of strengths that are free of their
/// bounds (C. Lawson, R. Hanson, Solving Least Squares Problems, 1974, chapter 23, with an upper bound too).
class BoundedMinimum {
 public:
  BoundedMinimum(const Eigen::MatrixXd& normal, const Eigen::VectorXd& right)
      : normal_(normal), right_(right), x_(Eigen::VectorXd::Zero(right.size())), isFree_(right.size(), false) {}

  Eigen::VectorXd find() {
    const Eigen::Index mostSteps = 10 * x_.size();
    for (Eigen::Index step = 0; step < mostSteps && freeTheSteepest(); ++step)
      while (!moveFree()) {
      }
    return x_;
  }

 private:
  /// @return whether there was a strength at a bound that wants away from it
  bool freeTheSteepest() {
    const Eigen::VectorXd slope = normal_ * x_ - right_;
    Eigen::Index steepest = -1;
    double most = slopeTolerance * (1.0 + right_.cwiseAbs().maxCoeff());
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      const double gain = isFree_[j] ? 0.0 : x_(j) > 0.0 ? slope(j) : -slope(j);
      if (gain <= most) continue;
      most = gain;
      steepest = j;
    }
    if (steepest >= 0) isFree_[steepest] = true;
    return steepest >= 0;
  }

  std::vector<Eigen::Index> freeOnes() const {
    std::vector<Eigen::Index> free;
    for (Eigen::Index j = 0; j < x_.size(); ++j)
      if (isFree_[j]) free.push_back(j);
    return free;
  }

  /// The minimum over the free strengths, without regard to their bounds.
  Eigen::VectorXd minimumOf(const std::vector<Eigen::Index>& free) const {
    Eigen::VectorXd fixed = x_;
    for (const Eigen::Index j : free) fixed(j) = 0.0;
    const Eigen::VectorXd rest = right_ - normal_ * fixed;
    const auto count = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd block(count, count);
    Eigen::VectorXd side(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      side(j) = rest(free[j]);
      for (Eigen::Index k = 0; k < count; ++k) block(j, k) = normal_(free[j], free[k]);
    }
    return block.llt().solve(side);
  }

  /// Moves the free strengths to their minimum, or as far as the first bound. @return whether they have reached it
  bool moveFree() {
    const std::vector<Eigen::Index> free = freeOnes();
    const Eigen::VectorXd aim = minimumOf(free);
    double share = 1.0;
    Eigen::Index first = -1;
    for (std::size_t j = 0; j < free.size(); ++j) {
      const double from = x_(free[j]), to = aim(j);
      if (to >= 0.0 && to <= 1.0) continue;
      const double reach = ((to < 0.0 ? 0.0 : 1.0) - from) / (to - from);
      if (reach >= share && first >= 0) continue;
      share = reach;
      first = static_cast<Eigen::Index>(j);
    }
    for (std::size_t j = 0; j < free.size(); ++j) x_(free[j]) += share * (aim(j) - x_(free[j]));
    if (first < 0) return true;
    x_(free[first]) = aim(first) < 0.0 ? 0.0 : 1.0;
    isFree_[free[first]] = false;
    return false;
  }

  const Eigen::MatrixXd& normal_;
  const Eigen::VectorXd& right_;
  Eigen::VectorXd x_;
  std::vector<bool> isFree_;
};

}  // namespace

ActionFit::ActionFit(const std::vector<CaptureAction>& actions, const FAPMask& used)
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
  const Eigen::VectorXd right = matrix_.transpose() * scaled(frame);
  return BoundedMinimum(normal_, right).find();
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
