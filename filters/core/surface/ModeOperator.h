#pragma once

#include <Eigen/Core>
#include <vector>

#include "Condition.h"
#include "ModeBasis.h"

namespace mien {

/// U_j(u): how the 2m boundary data of one harmonic spread over a patch [S eq. 5-11].
///
/// The solution of (d2/du2 - rate^2)^m y = 0 that meets the conditions is y(u) = row(u) . data.
class ModeOperator {
 public:
  /// @param rate        a n >= 0
  /// @param conditions  2m of them; their `curve` plays no part here, the order of the list does
  /// @param begin,end   the interval of u on which the solution is used; all conditions lie in it
  ModeOperator(double rate, const std::vector<Condition>& conditions, double begin = 0.0, double end = 1.0);

  /// The conditions determine a solution.
  bool solvable() const { return solvable_; }

  /// One row of U, or of its derivative with respect to u.
  Eigen::RowVectorXd row(double u, int derivative = 0) const;

  /// The largest sum of |U| over the interval, over the conditions on values only.
  double lebesgueConstant() const;

 private:
  /// What turns a derivative with respect to the interval, 0 .. 1, into one with respect to u.
  Extended unitOf(int derivative) const;
  double absoluteSum(double u) const;
  std::vector<double> lebesgueSamples() const;

  double begin_, length_, rate_;
  std::vector<double> nodes_;  ///< u of the conditions and the ends of the interval, ascending
  ModeBasis basis_;
  ExtendedMatrix coefficients_;  ///< inverse of the conditions applied to the basis
  std::vector<bool> isValue_;
  bool solvable_ = false;
};

}  // namespace mien
