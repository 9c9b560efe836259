#include "ProfileSettlement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "SettlementMemo.h"
#include "StaggeredWeights.h"

namespace mien {

ProfileSettlement ProfileSettlement::together() {
  constexpr int sweeps = 20000;
  constexpr double least = StaggeredWeights::leastUndershoot;
  return {{{least, 1.0}, {least, 1.005}, {least, 1.02}, {0.01, 1.05}, {0.04, 1.1}, {0.12, 1.25}}, sweeps};
}

ProfileSettlement ProfileSettlement::alone() {
  constexpr int sweeps = 1000;
  std::vector<Allowance> allowances;
  for (double undershoot = StaggeredWeights::leastUndershoot; undershoot < 0.04; undershoot *= 1.5)
    allowances.push_back({undershoot, 1.02});
  for (const double undershoot : {0.06, 0.09, 0.13}) allowances.push_back({undershoot, 1.0 + undershoot});
  return {allowances, sweeps};
}

int ProfileSettlement::add(const Eigen::VectorXd& weights, const Eigen::MatrixXd& conditions,
                           std::vector<double> places, bool parts) {
  profiles_.push_back({weights, conditions, std::move(places), parts});
  return static_cast<int>(profiles_.size()) - 1;
}

void ProfileSettlement::share(const std::vector<int>& profiles) {
  sets_.push_back(profiles);
}

/// Profiles by the first one that they share points with, directly or over others.
std::vector<std::vector<int>> ProfileSettlement::connectedProfiles() const {
  std::vector<int> first(profiles_.size());
  std::iota(first.begin(), first.end(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (const std::vector<int>& set : sets_) {
      int least = static_cast<int>(first.size());
      for (const int p : set) least = std::min(least, first[p]);
      for (const int p : set) {
        changed = changed || first[p] != least;
        first[p] = least;
      }
    }
  }
  std::map<int, std::vector<int>> members;
  for (std::size_t p = 0; p < first.size(); ++p) members[first[p]].push_back(static_cast<int>(p));
  std::vector<std::vector<int>> all;
  for (const auto& [least, profiles] : members) all.push_back(profiles);
  return all;
}

bool ProfileSettlement::settleWithin(const std::vector<int>& members, const Allowance& allowance, bool whateverBounds) {
  StaggeredWeights weights(allowance.undershoot, allowance.most);
  std::map<int, int> numbers;
  for (const int p : members)
    numbers[p] = weights.add(profiles_[p].weights, profiles_[p].conditions, profiles_[p].parts);
  for (const std::vector<int>& set : sets_) {
    std::vector<int> shared;
    for (const int p : set)
      if (numbers.count(p) > 0) shared.push_back(numbers[p]);
    if (!shared.empty()) weights.share(shared);
  }
  const bool solved = weights.solve(sweeps_) < 0;
  if (!solved && !whateverBounds) return false;
  if (!solved) weights.meetWhateverBounds();
  for (const auto& [p, number] : numbers) profiles_[p].weights = weights.weights(number);
  return true;
}

/// A profile narrower than the spacing of the samples gets the two beside its feature points, else nothing could move
/// these.
void ProfileSettlement::widen(Profile& profile) {
  constexpr double least = 0.1;
  const int k = static_cast<int>(profile.weights.size());
  for (const double place : profile.places)
    for (const int step : {0, 1}) {
      double& weight = profile.weights[(static_cast<int>(std::floor(place)) + step) % k];
      weight = std::max(weight, least);
    }
}

/// Sizes stand before what they count, so that no two questions read alike. A number that is none has no answer to be
/// remembered: it equals nothing.
std::vector<double> ProfileSettlement::question() const {
  std::vector<double> all = {double(sweeps_), double(allowances_.size()), double(profiles_.size()),
                             double(sets_.size())};
  for (const Allowance& allowance : allowances_) all.insert(all.end(), {allowance.undershoot, allowance.most});
  for (const Profile& profile : profiles_) {
    const Eigen::VectorXd& weights = profile.weights;
    const double* conditions = profile.conditions.data();
    all.insert(all.end(), {double(weights.size()), double(profile.conditions.rows()), double(profile.places.size()),
                           double(profile.parts)});
    all.insert(all.end(), weights.data(), weights.data() + weights.size());
    all.insert(all.end(), conditions, conditions + profile.conditions.size());
    all.insert(all.end(), profile.places.begin(), profile.places.end());
  }
  for (const std::vector<int>& set : sets_) {
    all.push_back(double(set.size()));
    all.insert(all.end(), set.begin(), set.end());
  }
  return all;
}

void ProfileSettlement::settle() {
  SettlementMemo& memo = SettlementMemo::shared();
  const std::vector<double> asked = question();
  const bool isSound = std::all_of(asked.begin(), asked.end(), [](double x) { return std::isfinite(x); });
  SettlementMemo::Answer answer;
  if (isSound && memo.find(asked, answer)) {
    for (std::size_t p = 0; p < profiles_.size(); ++p) profiles_[p].weights = answer[p];
    return;
  }
  settleAnew();
  for (const Profile& profile : profiles_) answer.push_back(profile.weights);
  if (isSound) memo.keep(asked, answer);
}

void ProfileSettlement::settleAnew() {
  for (const std::vector<int>& members : connectedProfiles()) {
    const auto serves = [&](const Allowance& allowance) { return settleWithin(members, allowance, false); };
    if (std::any_of(allowances_.begin(), allowances_.end(), serves)) continue;
    for (const int p : members) widen(profiles_[p]);
    settleWithin(members, allowances_.back(), true);
  }
}

}  // namespace mien
