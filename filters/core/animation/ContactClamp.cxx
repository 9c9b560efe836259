#include "ContactClamp.h"

#include <algorithm>
#include <cmath>

#include "FineColumns.h"

namespace mien {

namespace {

constexpr double deepestInterpolant = -0.09;  ///< mm; 0.1 is promised
constexpr int maximumLifts = 40;

/// y slope of a motion on one curve, K values for one interval.
Eigen::VectorXd verticalSlopes(const FAPMotion& motion, int interval, int curve, int k) {
  Eigen::VectorXd slopes = Eigen::VectorXd::Zero(k);
  for (size_t i = 0; i < motion.rows.size(); ++i)
    if (motion.rows[i] / k == curve) slopes[motion.rows[i] % k] += motion.perValue[interval](i, 1);
  return slopes;
}

/// The part of two displacements that moves both curves alike.
double common(double a, double b) {
  return a * b <= 0.0 ? 0.0 : std::copysign(std::min(std::abs(a), std::abs(b)), a);
}

}  // namespace

ContactClamp::ContactClamp(const ClosedCurves& neutral, const ContactPair& pair, const MotionBasis& basis)
    : pair_(pair), columns_(fineColumns(neutral.pointsPerCurve)) {
  const int k = neutral.pointsPerCurve;
  neutralUpper_ = neutral.curve(pair.upper).col(1);
  neutralLower_ = neutral.curve(pair.lower).col(1);
  neutralGap_ = neutralUpper_ - neutralLower_;
  neutralValues_ = columns_ * neutralGap_;
  // A face that crosses its lids between samples from the start cannot do better when it moves.
  floor_ = neutralValues_.cwiseMin(deepestInterpolant);
  mask_ = shared_ = correction_ = Eigen::VectorXd::Zero(k);
  rawGap_ = gap_ = neutralGap_;
  values_ = neutralValues_;
  for (const FAPMotion& motion : basis.motions())
    for (int i = 0; i < motion.intervals.intervals(); ++i) {
      const Eigen::VectorXd upper = verticalSlopes(motion, i, pair.upper, k);
      const Eigen::VectorXd lower = verticalSlopes(motion, i, pair.lower, k);
      mask_ = mask_.cwiseMax(((upper - lower).array().abs() > 1e-12).cast<double>().matrix());
      const Eigen::VectorXd both = upper.binaryExpr(lower, &common);
      if (!both.isZero(0.0)) sharedMotions_.push_back({&motion.intervals, motion.fap, i, both});
    }
}

/// @return whether the gap differs from the neutral one anywhere
bool ContactClamp::measureGap(const ClosedCurves& curves) {
  rawGap_ = curves.curve(pair_.upper).col(1) - curves.curve(pair_.lower).col(1);
  gap_ = (mask_.array() > 0.0).select(rawGap_.cwiseMax(neutralGap_.cwiseMin(0.0)), neutralGap_);
  return gap_ != neutralGap_ || rawGap_ != neutralGap_;
}

void ContactClamp::interpolate() {
  values_ = neutralValues_;
  for (int j = 0; j < gap_.size(); ++j)
    if (gap_[j] != neutralGap_[j]) values_ += (gap_[j] - neutralGap_[j]) * columns_.col(j);
}

bool ContactClamp::tooDeep() const {
  return ((values_ - floor_).array() < -1e-9).any();
}

/// Lifts the lowest column of every interval at once, so that mirrored motion stays mirrored.
void ContactClamp::liftOnce() {
  correction_.setZero();
  int dips = 0;
  for (int first = 0; first < values_.size(); first += columnsPerSample) {
    Eigen::Index lowest;
    const double dip =
        -(values_.segment(first, columnsPerSample) - floor_.segment(first, columnsPerSample)).minCoeff(&lowest);
    if (dip <= 0.0) continue;
    const auto row = columns_.row(first + lowest).transpose();
    const double length = row.cwiseProduct(mask_).squaredNorm();
    if (length < 1e-6) continue;
    correction_ += (dip + 0.005) / length * row.cwiseProduct(mask_);
    ++dips;
  }
  // The mean of projections converges where their sum would swing.
  if (dips > 0) gap_ = (gap_ + 1.5 / dips * correction_).cwiseMax(neutralGap_.cwiseMin(0.0));
}

void ContactClamp::drawTowardsNeutral() {
  double share = 0.0;
  for (int i = 0; i < values_.size(); ++i)
    if (values_[i] < floor_[i] && neutralValues_[i] > values_[i])
      share = std::max(share, (floor_[i] - values_[i]) / (neutralValues_[i] - values_[i]));
  gap_ += std::min(1.0, share) * (neutralGap_ - gap_);
}

void ContactClamp::sumShared(const FAPFrame& frame) {
  shared_.setZero();
  for (const SharedMotion& motion : sharedMotions_) {
    const double value = MotionBasis::usableValue(frame, motion.fap);
    if (value != 0.0) shared_ += motion.intervals->length(motion.interval, value) * motion.perValue;
  }
}

/// How far the middle of the gap moves at a sample.
double ContactClamp::meetingShift(int j, const ClosedCurves& curves) const {
  const double upper = curves.curve(pair_.upper)(j, 1) - neutralUpper_[j] - shared_[j];
  const double lower = curves.curve(pair_.lower)(j, 1) - neutralLower_[j] - shared_[j];
  const bool pressed = rawGap_[j] < neutralGap_[j] && rawGap_[j] < 0.0;
  const auto [least, most] = std::minmax(upper, lower);
  return shared_[j] + (pressed ? std::clamp(upper + lower, least, most) : 0.5 * (upper + lower));
}

void ContactClamp::moveCurves(const FAPFrame& frame, ClosedCurves& curves) {
  sumShared(frame);
  auto upper = curves.curve(pair_.upper);
  auto lower = curves.curve(pair_.lower);
  for (int j = 0; j < gap_.size(); ++j) {
    if (gap_[j] == rawGap_[j]) continue;
    clamped_ = std::max(clamped_, gap_[j] - rawGap_[j]);
    ++clampedSamples_;
    if (!pair_.upperYields)
      lower(j, 1) = 0.5 * (neutralUpper_[j] + neutralLower_[j]) + meetingShift(j, curves) - 0.5 * gap_[j];
    upper(j, 1) = lower(j, 1) + gap_[j];
  }
}

void ContactClamp::reset() {
  clamped_ = 0.0;
  clampedSamples_ = 0;
}

void ContactClamp::apply(const FAPFrame& frame, ClosedCurves& curves) {
  reset();
  if (!measureGap(curves)) return;
  interpolate();
  for (int i = 0; i < maximumLifts && tooDeep(); ++i) {
    liftOnce();
    interpolate();
  }
  if (tooDeep()) drawTowardsNeutral();
  moveCurves(frame, curves);
}

}  // namespace mien
