#pragma once

#include <Eigen/Core>
#include <vector>

namespace mien {

/// Settles the weights of FAPs that share points on one face (StaggeredWeights), whatever the face.
///
/// Profiles that share points, directly or over others, are settled together. Where a face leaves no room to meet every
/// feature point within the bounds (two feature points near one sample, a bump of few samples), sums above 1 and dips
/// below 0 are allowed step by step; at last the bounds give way and the feature points are met. No face is refused.
class ProfileSettlement {
 public:
  /// How far the weights may leave 0 .. 1.
  struct Allowance {
    double undershoot, most;
  };

  /// @param allowances    tried in this order
  /// @param sweeps        at most, for each allowance
  ProfileSettlement(std::vector<Allowance> allowances, int sweeps)
      : allowances_(std::move(allowances)), sweeps_(sweeps) {}

  /// For profiles of a group: strict, where the face allows it.
  static ProfileSettlement together();

  /// For a profile that shares its points with no other: a bump of a few samples dips beside itself whatever its shape,
  /// so that it gets the least undershoot that serves, and a sample beside the feature point may move a little further
  /// than it.
  static ProfileSettlement alone();

  /// @param conditions  cardinal weights where the profile is to interpolate to 1, a row each
  /// @param places      where these lie, in samples
  /// @param parts       whether it parts two touching curves
  /// @return the number of the profile
  int add(const Eigen::VectorXd& weights, const Eigen::MatrixXd& conditions, std::vector<double> places, bool parts);
  void share(const std::vector<int>& profiles);  ///< their sum is bounded

  void settle();  ///< what was settled before is remembered (SettlementMemo)

  const Eigen::VectorXd& weights(int profile) const { return profiles_[profile].weights; }

 private:
  struct Profile {
    Eigen::VectorXd weights;
    Eigen::MatrixXd conditions;
    std::vector<double> places;
    bool parts;
  };

  std::vector<double> question() const;
  void settleAnew();
  std::vector<std::vector<int>> connectedProfiles() const;
  bool settleWithin(const std::vector<int>& members, const Allowance& allowance, bool whateverBounds);
  static void widen(Profile& profile);

  std::vector<Allowance> allowances_;
  int sweeps_;
  std::vector<Profile> profiles_;
  std::vector<std::vector<int>> sets_;
};

}  // namespace mien
