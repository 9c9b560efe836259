#include "HarmonicSplit.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

/// Derivatives turn cos(nv) by a quarter each time.
double turnedCosine(int n, double v, int derivative) {
  return std::pow(n, derivative) * std::cos(n * v + derivative * M_PI_2);
}

double turnedSine(int n, double v, int derivative) {
  return std::pow(n, derivative) * std::sin(n * v + derivative * M_PI_2);
}

}  // namespace

HarmonicSplit::HarmonicSplit(int pointsPerCurve, int modes, bool remainder)
    : pointsPerCurve_(pointsPerCurve), modes_(modes), remainder_(remainder) {}

int HarmonicSplit::coefficientCount(int part) const {
  const int first = firstCoefficient(part);
  const int end = part > modes_ ? pointsPerCurve_ : (part == 0 ? 1 : first + 2);
  return std::max(0, std::min(end, pointsPerCurve_) - first);
}

Eigen::MatrixXd HarmonicSplit::analysis() const {
  const int k = pointsPerCurve_;
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(k, 0.0, 2.0 * M_PI * (k - 1) / k);
  Eigen::MatrixXd coefficients = synthesis(v, 0).transpose() * (2.0 / k);
  coefficients.row(0) *= 0.5;
  coefficients.row(k - 1) *= 0.5;  // the highest cosine is its own alias
  return coefficients;
}

Eigen::MatrixXd HarmonicSplit::synthesis(const Eigen::VectorXd& v, int derivative) const {
  Eigen::MatrixXd values(v.size(), pointsPerCurve_);
  for (Eigen::Index i = 0; i < v.size(); ++i)
    for (int column = 0; column < pointsPerCurve_; ++column) {
      const int n = (column + 1) / 2;
      values(i, column) =
          column % 2 || column == 0 ? turnedCosine(n, v[i], derivative) : turnedSine(n, v[i], derivative);
    }
  return values;
}

}  // namespace mien
