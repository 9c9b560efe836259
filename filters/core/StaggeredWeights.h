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
/// - each profile with a feature point interpolates to 1 there,
/// - no weight is negative and the weights of each sharing set sum to at most 1 at every sample,
/// - profiles that part two touching curves interpolate to no less than -`undershoot` anywhere.
/// A profile stays 0 where it was 0; among the changes that serve, the one of least second differences is taken.
class StaggeredWeights {
 public:
  static constexpr double undershoot = 0.002;  ///< 0.08 mm for a mouth that opens by 40 mm

  /// @param atFeature cardinal weights at the feature point, or empty when none is to be met
  /// @return the number of the profile
  int add(const Eigen::VectorXd& weights, const Eigen::VectorXd& atFeature, bool parts);
  void share(const std::vector<int>& profiles);  ///< their sum is bounded by 1

  /// @return the profile that cannot meet its conditions, or -1
  int solve();

  const Eigen::VectorXd& weights(int profile) const { return profiles_[profile].weights; }

 private:
  struct Profile {
    Eigen::VectorXd weights, atFeature;
    Eigen::MatrixXd smoothing;  ///< turns a condition on the weights into the smoothest change that serves it
    bool parts = false;
  };

  double meetFeature(Profile& profile) const;
  double bound(const std::vector<int>& set, int sample);
  double liftBetweenSamples(Profile& profile) const;
  double sweep();

  std::vector<Profile> profiles_;
  std::vector<std::vector<int>> sets_;
  Eigen::MatrixXd columns_;  ///< interpolation between the samples, when a profile parts curves
};

}  // namespace mien
