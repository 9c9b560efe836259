#include "ModeOperator.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace mien {

namespace {

/// Samples of the Lebesgue sum between two conditions; its maximum is then narrowed down between the neighbours of the
/// largest.
constexpr int samplesPerInterval = 16;

/// The largest value that a golden-section search meets where f has one maximum; the error is the square of 1e-5 of the
/// bracket.
template <class Function>
double largestBetween(double begin, double end, const Function& f) {
  constexpr double golden = 0.6180339887498949;
  constexpr int steps = 24;
  double left = end - golden * (end - begin), right = begin + golden * (end - begin);
  double atLeft = f(left), atRight = f(right);
  for (int i = 0; i < steps; ++i) {
    if (atLeft > atRight) {
      end = right;
      right = left;
      atRight = atLeft;
      atLeft = f(left = end - golden * (end - begin));
    } else {
      begin = left;
      left = right;
      atLeft = atRight;
      atRight = f(right = begin + golden * (end - begin));
    }
  }
  return std::max(atLeft, atRight);
}

}  // namespace

ModeOperator::ModeOperator(double rate, const std::vector<Condition>& conditions, double begin, double end)
    : begin_(begin),
      length_(end - begin),
      rate_(rate),
      basis_(rate * (end - begin), static_cast<int>(conditions.size())) {
  const int n = basis_.order();
  ExtendedMatrix system(n, n);
  ExtendedRow scale(n);
  for (int i = 0; i < n; ++i) {
    const Condition& condition = conditions[i];
    const Extended u = (static_cast<Extended>(condition.u) - begin_) / length_;
    const ExtendedRow row = basis_.row(u, condition.derivative) * unitOf(condition.derivative);
    scale[i] = row.cwiseAbs().maxCoeff();
    system.row(i) = row / scale[i];
    isValue_.push_back(condition.derivative == 0);
    nodes_.push_back(condition.u);
  }
  nodes_.insert(nodes_.end(), {begin, end});
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  const Eigen::FullPivLU<ExtendedMatrix> factors(system);
  solvable_ = scale.allFinite() && (scale.array() > 0).all() && factors.isInvertible();
  if (solvable_) coefficients_ = factors.inverse() * scale.cwiseInverse().asDiagonal();
}

Eigen::RowVectorXd ModeOperator::row(double u, int derivative) const {
  const Extended local = (static_cast<Extended>(u) - begin_) / length_;
  return ((basis_.row(local, derivative) * unitOf(derivative)) * coefficients_).cast<double>();
}

Extended ModeOperator::unitOf(int derivative) const {
  Extended unit = 1;
  for (int i = 0; i < derivative; ++i) unit /= length_;
  return unit;
}

double ModeOperator::absoluteSum(double u) const {
  const Eigen::RowVectorXd values = row(u);
  double sum = 0.0;
  for (size_t i = 0; i < isValue_.size(); ++i)
    if (isValue_[i]) sum += std::abs(values[i]);
  return sum;
}

double ModeOperator::lebesgueConstant() const {
  const std::vector<double> samples = lebesgueSamples();
  std::vector<double> sums;
  for (const double u : samples) sums.push_back(absoluteSum(u));
  const size_t best = std::max_element(sums.begin(), sums.end()) - sums.begin();
  const double before = samples[best > 0 ? best - 1 : 0], after = samples[std::min(best + 1, samples.size() - 1)];
  const double refined = largestBetween(before, after, [this](double u) { return absoluteSum(u); });
  return std::max(sums[best], refined);
}

// The sum is smooth between conditions but has layers of width 1 / rate beside them.
std::vector<double> ModeOperator::lebesgueSamples() const {
  std::vector<double> samples;
  for (size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double begin = nodes_[i], length = nodes_[i + 1] - begin;
    for (int j = 0; j < samplesPerInterval; ++j) samples.push_back(begin + length * j / samplesPerInterval);
    for (double layer = 0.25; rate_ > 0.0 && layer < 10.0; layer *= 1.5) {
      const double width = layer / rate_;
      if (width >= length / samplesPerInterval) break;
      samples.push_back(begin + width);
      samples.push_back(begin + length - width);
    }
  }
  samples.push_back(nodes_.back());
  std::sort(samples.begin(), samples.end());
  return samples;
}

}  // namespace mien
