#include "SharedDerivatives.h"

#include "FaceLayout.h"

#include <algorithm>

namespace mien {

namespace {

constexpr double curvesPerU = FaceLayout::curvesPerPatch - 1.0;
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

Eigen::MatrixXd differences(int order, int n) { return order == 1 ? slopes(n) : bends(n); }

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

Eigen::MatrixXd sharedDerivatives(int order) {
  const Eigen::MatrixXd oneChain = differences(order, curveCount - 1) * closedMouth();
  Eigen::MatrixXd result(curveCount, curveCount);
  result << oneChain.topRows(lowerLip), oneChain.bottomRows(curveCount - lowerLip);
  const Eigen::MatrixXd gap = lipGap();
  result.topRows(lowerLip) += differences(order, lowerLip) * gap.topRows(lowerLip);
  result.bottomRows(curveCount - lowerLip) += differences(order, curveCount - lowerLip) * gap.bottomRows(curveCount - lowerLip);
  return result;
}

}  // namespace mien
