#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace mien {

/// Weights of FAPs that share points, bound to the samples of one face.
///
/// Samples of staggered sinusoids do not give a feature point between two samples exactly its weight 1,
/// as the curve there is the trigonometric interpolant. The profiles are therefore moved, as little as
/// alternating projections need, until
/// - each profile interpolates to 1 at its feature points,
/// - no weight is negative and the weights of each sharing set sum to at most `most` (1) at every sample,
/// - profiles that part two touching curves interpolate to no less than -undershoot anywhere.
/// A profile stays 0 where it was 0; among the changes that serve, the one of least second differences is taken.
class StaggeredWeights {
 public:
  static constexpr double leastUndershoot = 0.002;  ///< 0.08 mm for a mouth that opens by 40 mm

  explicit StaggeredWeights(double undershoot = leastUndershoot, double most = 1.0)
      : undershoot_(undershoot), most_(most) {}

  /// @param conditions cardinal weights at the points where the profile is to interpolate to 1, a row each; may be
  /// empty
  /// @return the number of the profile
  int add(const Eigen::VectorXd& weights, const Eigen::MatrixXd& conditions, bool parts);
  void share(const std::vector<int>& profiles);  ///< their sum is bounded

  /// @return the profile that cannot meet its conditions, or -1
  int solve(int maximumSweeps = 20000);

  /// After a solve() that failed: every profile is moved until it meets its conditions, beyond its bounds.
  void meetWhateverBounds();

  const Eigen::VectorXd& weights(int profile) const { return profiles_[profile].weights; }

 private:
  struct Profile {
    Eigen::VectorXd weights;
    Eigen::MatrixXd conditions;
    Eigen::MatrixXd smoothing;  ///< turns a condition on the weights into the smoothest change that serves it
    bool parts = false;
  };

  double meetConditions(Profile& profile) const;
  double bound(const std::vector<int>& set, int sample);
  double liftBetweenSamples(Profile& profile) const;
  double sweep();

  double undershoot_, most_;
  std::vector<Profile> profiles_;
  std::vector<std::vector<int>> sets_;
  Eigen::MatrixXd columns_;  ///< interpolation between the samples, when a profile parts curves
};

}  // namespace mien
