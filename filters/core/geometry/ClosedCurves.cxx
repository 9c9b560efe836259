#include "ClosedCurves.h"

#include <cmath>

namespace mien {

ClosedCurves::ClosedCurves(int curveCount, int samplesPerCurve)
    : count(curveCount), pointsPerCurve(samplesPerCurve), points(curveCount * samplesPerCurve, 3) {
  points.setZero();
}

Eigen::Vector3d ClosedCurves::at(int curveIndex, double v) const {
  return curve(curveIndex).transpose() * cardinalWeights(pointsPerCurve, v);
}

Eigen::VectorXd cardinalWeights(int pointsPerCurve, double v) {
  const double step = 2.0 * M_PI / pointsPerCurve;
  Eigen::VectorXd weights(pointsPerCurve);
  for (int j = 0; j < pointsPerCurve; ++j) {
    const double x = std::remainder(v - j * step, 2.0 * M_PI);
    const bool atSample = std::abs(x) < 1e-13;
    weights[j] = atSample ? 1.0 : std::sin(0.5 * pointsPerCurve * x) / (pointsPerCurve * std::tan(0.5 * x));
  }
  return weights;
}

std::string describePointFault(const ClosedCurves& curves, const std::function<std::string(int)>& nameOfCurve) {
  const int k = curves.pointsPerCurve;
  for (int row = 0; row < curves.points.rows(); ++row) {
    const double largest = curves.points.row(row).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
    if (largest <= ClosedCurves::largestCoordinate) continue;
    return "curve " + nameOfCurve(row / k) + ", point " + std::to_string(row % k) + " (counted from 0) " +
           (std::isfinite(largest) ? "lies past 1e+15, where single precision ends; give coordinates in a larger unit"
                                   : "is not a finite number");
  }
  return {};
}

std::string describeFault(const ClosedCurves& curves, int minimumPoints) {
  const int k = curves.pointsPerCurve;
  if (k < minimumPoints || k % 2 != 0)
    return "curves have " + std::to_string(k) + " points each; an even number of at least " +
           std::to_string(minimumPoints) + " is needed";
  return describePointFault(curves, [](int index) { return std::to_string(index + 1); });
}

}  // namespace mien
