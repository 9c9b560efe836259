#pragma once

#include <Eigen/Core>
#include <vector>

#include "FAPSequence.h"
#include "FacialActionMap.h"

namespace mien {

/// Facial actions that come nearest to FAP values: strengths x within 0 .. 1 that minimise
///   sum over the FAPs ((A x - f) / s)^2 + lambda |x|^2,
/// A(fap, action) the values of the actions, f the frame, s the largest value that an action gives the FAP (so that
/// FAPs of all units count alike), lambda = 1e-4 (the smallest of equally good answers; see doc/decisions.md).
/// Low-level FAPs only.
class ActionFit {
 public:
  ActionFit(const std::vector<CaptureAction>& actions, const FAPMask& used);

  /// Strengths of the actions, in their order.
  Eigen::VectorXd solve(const FAPFrame& frame) const;

  /// What these strengths give.
  FAPFrame framesOf(const Eigen::VectorXd& strengths) const;

  /// |f / s|^2 and |(A x - f) / s|^2: how much the frame moves and how much of that is lost.
  double movement(const FAPFrame& frame) const { return scaled(frame).squaredNorm(); }
  double loss(const FAPFrame& frame, const Eigen::VectorXd& strengths) const;

  /// Whether an action moves this FAP, and the animation too.
  bool moves(int fap) const { return scale_(fap - 1) > 0.0; }

 private:
  Eigen::VectorXd scaled(const FAPFrame& frame) const;

  Eigen::MatrixXd
      matrix_;  ///< 68 x actions, rows divided by scale_ (0 where no action moves the FAP, or it is not used)
  Eigen::VectorXd scale_;
  Eigen::MatrixXd normal_;  ///< matrix_^T matrix_ + lambda
};

}  // namespace mien
