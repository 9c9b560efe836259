#include "StaggeredWeights.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "FineColumns.h"

namespace mien {

namespace {

constexpr double precision = 1e-13;  ///< on weights: far below the 1e-9 mm asked of feature points
constexpr double acceptable = 1e-11;
/// A profile that ends at a sample is 0 there up to rounding. Taken for a weight, that sample would join the change on
/// one side of the face and not on the other.
constexpr double negligibleWeight = 1e-9;

/// The inverse of D^T D on the samples where the profile is not 0, with D the second differences of a change
/// that is 0 elsewhere.
Eigen::MatrixXd smoothingOperator(const Eigen::VectorXd& weights) {
  const int k = static_cast<int>(weights.size());
  std::vector<int> support;
  for (int j = 0; j < k; ++j)
    if (weights[j] > 0.0) support.push_back(j);
  const int n = static_cast<int>(support.size());
  Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(k, n);
  for (int i = 0; i < n; ++i) {
    differences(support[i], i) = -2.0;
    for (int step : {1, k - 1}) differences((support[i] + step) % k, i) = 1.0;
  }
  const Eigen::MatrixXd inverse = (differences.transpose() * differences).inverse();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(k, k);
  for (int i = 0; i < n; ++i)
    for (int m = 0; m < n; ++m) result(support[i], support[m]) = inverse(i, m);
  return result;
}

}  // namespace

int StaggeredWeights::add(const Eigen::VectorXd& weights, const Eigen::MatrixXd& conditions, bool parts) {
  const Eigen::VectorXd clean = (weights.array().abs() > negligibleWeight).select(weights, 0.0);
  profiles_.push_back({clean, conditions, smoothingOperator(clean), parts});
  if (parts && columns_.size() == 0) columns_ = fineColumns(static_cast<int>(weights.size()));
  return static_cast<int>(profiles_.size()) - 1;
}

void StaggeredWeights::share(const std::vector<int>& profiles) {
  if (std::find(sets_.begin(), sets_.end(), profiles) == sets_.end()) sets_.push_back(profiles);
}

/// Projects onto the profiles that interpolate to 1 at each of the feature points; gives the largest error there was.
double StaggeredWeights::meetConditions(Profile& profile) const {
  double largest = 0.0;
  for (Eigen::Index c = 0; c < profile.conditions.rows(); ++c) {
    const Eigen::VectorXd normal = profile.smoothing * profile.conditions.row(c).transpose();
    const double length = profile.conditions.row(c).dot(normal);
    const double error = 1.0 - profile.conditions.row(c).dot(profile.weights);
    if (length > 0.0) profile.weights += error / length * normal;
    largest = std::max(largest, std::abs(error));
  }
  return largest;
}

/// Projects the weights of a set at one sample onto w >= 0, sum <= most; gives the largest change.
double StaggeredWeights::bound(const std::vector<int>& set, int sample) {
  double excess = 0.0;
  const auto sumAbove = [&](double level) {
    double sum = 0.0;
    for (int p : set) sum += std::max(0.0, profiles_[p].weights[sample] - level);
    return sum;
  };
  // The level is found from below: each step is exact when no further weight drops to 0.
  for (size_t step = 0; step < set.size() && sumAbove(excess) > most_; ++step) {
    int positive = 0;
    for (int p : set) positive += profiles_[p].weights[sample] > excess;
    excess += (sumAbove(excess) - most_) / positive;
  }
  double change = 0.0;
  for (int p : set) {
    double& weight = profiles_[p].weights[sample];
    const double bounded = std::max(0.0, weight - excess);
    change = std::max(change, std::abs(bounded - weight));
    weight = bounded;
  }
  return change;
}

/// Lifts the interpolant where it dips too low, once in every interval between samples and all at once, so
/// that a mirrored profile stays mirrored; gives the deepest dip below what is allowed.
double StaggeredWeights::liftBetweenSamples(Profile& profile) const {
  if (!profile.parts) return 0.0;
  const Eigen::VectorXd values = columns_ * profile.weights;
  Eigen::VectorXd correction = Eigen::VectorXd::Zero(profile.weights.size());
  double deepest = 0.0;
  int dips = 0;
  for (int first = 0; first < values.size(); first += columnsPerSample) {
    Eigen::Index lowest;
    const double dip = -undershoot_ - values.segment(first, columnsPerSample).minCoeff(&lowest);
    if (dip <= 0.0) continue;
    const Eigen::VectorXd normal = profile.smoothing * columns_.row(first + lowest).transpose();
    const double length = columns_.row(first + lowest).dot(normal);
    if (length < 1e-12) continue;
    correction += dip / length * normal;
    deepest = std::max(deepest, dip);
    ++dips;
  }
  // Between neighbouring samples the normals are nearly parallel: their mean converges, their sum would not.
  if (dips > 0) profile.weights += 1.5 / dips * correction;
  return deepest;
}

double StaggeredWeights::sweep() {
  double error = 0.0;
  for (Profile& profile : profiles_) {
    error = std::max(error, liftBetweenSamples(profile));
    error = std::max(error, meetConditions(profile));
  }
  for (const auto& set : sets_)
    for (int j = 0; j < profiles_[set.front()].weights.size(); ++j) error = std::max(error, bound(set, j));
  return error;
}

/// Where the error no longer halves in so many sweeps, the rest of them would not bring it to `precision`.
int StaggeredWeights::solve(int maximumSweeps) {
  constexpr int sweepsToHalve = 1000;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= maximumSweeps; ++i) {
    const double error = sweep();
    if (error <= precision) break;
    if (i % sweepsToHalve != 0) continue;
    if (error > acceptable && error > 0.5 * before) break;
    before = error;
  }
  for (size_t p = 0; p < profiles_.size(); ++p) {
    const Profile& profile = profiles_[p];
    const Eigen::VectorXd errors =
        profile.conditions * profile.weights - Eigen::VectorXd::Ones(profile.conditions.rows());
    if (errors.size() > 0 && !(errors.cwiseAbs().maxCoeff() < acceptable)) return static_cast<int>(p);
  }
  return -1;
}

void StaggeredWeights::meetWhateverBounds() {
  constexpr int rounds = 1000;  // a profile with two conditions alternates between them
  for (Profile& profile : profiles_)
    for (int i = 0; i < rounds && meetConditions(profile) > precision; ++i) continue;
}

}  // namespace mien
