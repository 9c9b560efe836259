#include "EffectiveValues.h"

#include <algorithm>
#include <cmath>

#include "FAPTable.h"
#include "MotionDirection.h"

namespace mien {

namespace {

constexpr double ownHalf = 2.0, ownWhole = 1.0;

double soft(double value, double threshold) {
  return std::copysign(std::max(0.0, std::abs(value) - threshold), value);
}

/// The shift of a point of a curve for one FAP value, per interval, along the direction and in the unit of another FAP.
std::vector<double> carriedAt(const FAPMotion& motion, const FeaturePoint& point, int fap, const FaceCurves& face,
                              const FAPUnits& units) {
  const int k = face.curves.pointsPerCurve;
  const Eigen::VectorXd cardinal = cardinalWeights(k, point.v);
  const FAPDefinition& definition = fapDefinition(fap);
  const Eigen::Vector3d direction = motionDirection(definition.positiveMotion) / units.perValue(definition.unit);
  std::vector<double> perValue(motion.perValue.size(), 0.0);
  for (size_t r = 0; r < motion.rows.size(); ++r)
    if (motion.rows[r] / k == point.curve)
      for (size_t i = 0; i < perValue.size(); ++i)
        perValue[i] += cardinal[motion.rows[r] % k] * motion.perValue[i].row(r).dot(direction.transpose());
  return perValue;
}

}  // namespace

EffectiveValues::EffectiveValues(const FaceCurves& face, const AnimationTable& table, const MotionBasis& basis,
                                 const FAPUnits& units) {
  for (const AnimationEntry& entry : table.entries()) {
    if (!basis.motion(entry.fap)) continue;
    faps_.push_back(entry.fap);
    for (const FAPLoan& loan : entry.lends)
      if (basis.motion(loan.fap)) loans_.push_back({entry.fap, loan.fap, loan.share});
    const FeaturePoint* point = face.feature(std::string(fapDefinition(entry.fap).featurePoint));
    for (const auto& [faps, yield] : {std::pair{&entry.replaces, ownHalf}, {&entry.beyond, ownWhole}}) {
      Claim claim{entry.fap, yield, {}};
      for (int other : *faps)
        if (const FAPMotion* motion = basis.motion(other))
          claim.others.push_back({motion, carriedAt(*motion, *point, entry.fap, face, units)});
      if (!claim.others.empty()) claims_.push_back(std::move(claim));
    }
  }
  std::stable_sort(loans_.begin(), loans_.end(), [](const Loan& a, const Loan& b) { return a.to < b.to; });
}

void EffectiveValues::lend(const FAPFrame& frame) {
  for (size_t i = 0; i < loans_.size();) {
    const int taker = loans_[i].to;
    double lent = 0.0;
    for (; i < loans_.size() && loans_[i].to == taker; ++i)
      lent += loans_[i].share * MotionBasis::usableValue(frame, loans_[i].from);
    const double own = MotionBasis::usableValue(frame, taker);
    values_.setValue(taker, own + soft(lent, ownHalf * std::abs(own)));
  }
}

void EffectiveValues::claim(const Claim& claim) {
  double carried = 0.0;
  for (const Carried& other : claim.others) {
    const double value = values_.value(other.motion->fap);
    for (size_t i = 0; i < other.perValue.size(); ++i)
      carried += other.perValue[i] * other.motion->intervals.length(static_cast<int>(i), value);
  }
  const double own = values_.value(claim.fap), most = claim.yield * std::abs(own);
  values_.setValue(claim.fap, own - std::clamp(carried, -most, most));
}

const FAPFrame& EffectiveValues::resolve(const FAPFrame& frame) {
  values_ = frame;
  for (int fap : faps_) values_.setValue(fap, MotionBasis::usableValue(frame, fap));
  lend(frame);
  for (const Claim& claim : claims_) this->claim(claim);
  return values_;
}

}  // namespace mien
