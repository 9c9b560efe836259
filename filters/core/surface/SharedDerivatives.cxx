#include "SharedDerivatives.h"

#include <Eigen/LU>
#include <algorithm>

#include "ModeOperator.h"

namespace mien {

namespace {

constexpr int intervalsPerPatch = FaceLayout::curvesPerPatch - 1;
constexpr double curvesPerU = intervalsPerPatch;
using FaceLayout::curveCount;
using FaceLayout::lowerLip;
using FaceLayout::upperLip;

/// First differences of a chain of n curves.
Eigen::MatrixXd slopes(int n) {
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    const int before = std::max(i - 1, 0), after = std::min(i + 1, n - 1);
    difference(i, after) += curvesPerU / (after - before);
    difference(i, before) -= curvesPerU / (after - before);
  }
  return difference;
}

/// Second differences of a chain of n curves; the ends take those of their neighbours.
Eigen::MatrixXd bends(int n) {
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    const int centre = std::clamp(i, 1, n - 2);
    difference.block<1, 3>(i, centre - 1) << 1.0, -2.0, 1.0;
  }
  return difference * curvesPerU * curvesPerU;
}

/// Two rows, for the begin and the end of an interval: S_uu from the values and slopes at both ends
/// (value, slope at the begin; value, slope at the end).
Eigen::Matrix<double, 2, 4> endCurvatures(double rate) {
  const double length = 1.0 / curvesPerU;
  const ModeOperator mode(rate, {{0.0, 0, 0}, {0.0, 1, 0}, {length, 0, 0}, {length, 1, 0}}, 0.0, length);
  Eigen::Matrix<double, 2, 4> curvatures;
  curvatures << mode.row(0.0, 2), mode.row(length, 2);
  return curvatures;
}

/// One chain of 28: the mean of both lips at the lip line. Columns: the 29 curves.
Eigen::MatrixXd closedMouth() {
  Eigen::MatrixXd chain = Eigen::MatrixXd::Zero(curveCount - 1, curveCount);
  for (int c = 0; c < curveCount; ++c) chain(c <= upperLip ? c : c - 1, c) = 1.0;
  chain.row(upperLip) *= 0.5;
  return chain;
}

/// What is left for the two chains of the open mouth: -+ half the gap at the lips.
Eigen::MatrixXd lipGap() {
  Eigen::MatrixXd gap = Eigen::MatrixXd::Zero(curveCount, curveCount);
  gap.block<2, 2>(upperLip, upperLip) << 0.5, -0.5, -0.5, 0.5;
  return gap;
}

}  // namespace

Eigen::MatrixXd differenceDerivatives(int order, const std::vector<double>& rates) {
  const int n = static_cast<int>(rates.size()) + 1;
  return order == 1 ? slopes(n) : bends(n);
}

// Row i: S_uu at the end of interval i - 1 equals S_uu at the begin of interval i.
Eigen::MatrixXd splineDerivatives(int, const std::vector<double>& rates) {
  const int n = static_cast<int>(rates.size()) + 1;
  Eigen::MatrixXd ofSlopes = Eigen::MatrixXd::Zero(n, n), ofValues = Eigen::MatrixXd::Zero(n, n);
  Eigen::Matrix<double, 2, 4> curvature;
  for (int interval = 0; interval + 1 < n; ++interval) {
    if (interval == 0 || rates[interval] != rates[interval - 1]) curvature = endCurvatures(rates[interval]);
    for (int side = 0; side < 2; ++side)
      for (int end = 0; end < 2; ++end) {
        const double sign = side == 0 ? 1.0 : -1.0;
        ofValues(interval + side, interval + end) += sign * curvature(side, 2 * end);
        ofSlopes(interval + side, interval + end) += sign * curvature(side, 2 * end + 1);
      }
  }
  return -ofSlopes.partialPivLu().solve(ofValues);
}

Eigen::MatrixXd sharedDerivatives(ChainDerivatives rule, int order,
                                  const std::array<double, FaceLayout::patchCount>& rates) {
  std::vector<double> ofIntervals;
  for (const double rate : rates) ofIntervals.insert(ofIntervals.end(), intervalsPerPatch, rate);
  const std::vector<double> above(ofIntervals.begin(), ofIntervals.begin() + upperLip);
  const std::vector<double> below(ofIntervals.begin() + upperLip, ofIntervals.end());
  const Eigen::MatrixXd oneChain = rule(order, ofIntervals) * closedMouth();
  const Eigen::MatrixXd gap = lipGap();
  Eigen::MatrixXd result(curveCount, curveCount);
  result << oneChain.topRows(lowerLip), oneChain.bottomRows(curveCount - lowerLip);
  result.topRows(lowerLip) += rule(order, above) * gap.topRows(lowerLip);
  result.bottomRows(curveCount - lowerLip) += rule(order, below) * gap.bottomRows(curveCount - lowerLip);
  return result;
}

}  // namespace mien
