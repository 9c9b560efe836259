#include "FaceAnimator.h"

#include <algorithm>
#include <cmath>

namespace mien {

std::string FaceAnimator::bind(const FaceCurves& neutral, const AnimationTable& table) {
  std::string fault = describeFault(neutral);
  if (fault.empty()) fault = describeFault(neutral.curves, minimumPointsPerCurve);
  if (!fault.empty()) return fault;
  auto binding = std::make_unique<Binding>(neutral, table);
  fault = measureFAPUnits(neutral, binding->units);
  if (fault.empty()) fault = binding->basis.bind(binding->neutral, binding->table, binding->units);
  if (!fault.empty()) return fault;
  for (const ContactPair& pair : table.contacts())
    binding->contacts.emplace_back(binding->neutral.curves, pair, binding->basis);
  binding->order = std::make_unique<CurveOrder>(binding->neutral.curves, table.contacts());
  binding->sides = std::make_unique<SideOrder>(binding->neutral.curves, table.sideways());
  binding->values = std::make_unique<EffectiveValues>(binding->neutral, binding->table, binding->basis, binding->units);
  binding->slack.resize(binding->neutral.curves.points.rows());
  binding->groups.assign(binding->slack.size(), -1);
  for (int group = 0; group < static_cast<int>(binding->basis.groups().size()); ++group)
    for (int row : binding->basis.pointsOfGroup(group)) binding->groups[row] = group;
  bound_ = std::move(binding);
  return {};
}

/// @return whether anything moves
bool FaceAnimator::displace(const FAPFrame& frame) {
  ClosedCurves::Points& points = bound_->animated.points;
  points = bound_->neutral.curves.points;
  std::fill(bound_->slack.begin(), bound_->slack.end(), 0.0);
  bool moved = false;
  for (const FAPMotion& motion : bound_->basis.motions()) {
    const double value = MotionBasis::usableValue(frame, motion.fap);
    if (value == 0.0) continue;
    moved = true;
    for (int i = 0; i < motion.intervals.intervals(); ++i) {
      const double length = motion.intervals.length(i, value);
      if (length == 0.0) continue;
      for (size_t r = 0; r < motion.rows.size(); ++r) {
        const int row = motion.rows[r];
        points.row(row) += length * motion.perValue[i].row(r);
        if (bound_->groups[row] != motion.group) bound_->slack[row] += std::abs(length) * motion.lengths[i][r];
      }
    }
  }
  return moved;
}

/// Height comes first, as contact depends on it: the shift along x and z gives way where both together would
/// take a point of a group further than the largest single displacement and what FAPs outside the group add.
void FaceAnimator::limitGroups(const FAPFrame& frame) {
  const MotionBasis& basis = bound_->basis;
  for (int group = 0; group < static_cast<int>(basis.groups().size()); ++group) {
    double largest = 0.0;
    for (const FAPMotion& motion : basis.motions())
      if (motion.group == group) largest = std::max(largest, motion.reach(MotionBasis::usableValue(frame, motion.fap)));
    for (int row : basis.pointsOfGroup(group)) {
      const Eigen::RowVector3d start = bound_->neutral.curves.points.row(row);
      Eigen::RowVector3d shift = bound_->animated.points.row(row) - start;
      const double level = std::hypot(shift.x(), shift.z());
      const double radius = largest + bound_->slack[row];
      const double allowed = std::sqrt(std::max(0.0, radius * radius - shift.y() * shift.y()));
      if (level <= allowed * (1.0 + 1e-12) || level <= 1e-9) continue;
      bound_->animated.points(row, 0) = start.x() + shift.x() * allowed / level;
      bound_->animated.points(row, 2) = start.z() + shift.z() * allowed / level;
    }
  }
}

const ClosedCurves& FaceAnimator::animate(const FAPFrame& wanted) {
  const FAPFrame& frame = bound_->values->resolve(wanted);
  const bool moved = displace(frame);
  for (ContactClamp& contact : bound_->contacts) contact.reset();
  bound_->order->reset();
  bound_->sides->reset();
  if (!moved) return bound_->animated;
  for (ContactClamp& contact : bound_->contacts) contact.apply(frame, bound_->animated);
  limitGroups(frame);
  bound_->sides->restore(bound_->animated);
  bound_->order->restore(bound_->animated);
  return bound_->animated;
}

const FaceCurves& FaceAnimator::neutral() const {
  return bound_->neutral;
}

const FAPUnits& FaceAnimator::units() const {
  return bound_->units;
}

const MotionBasis& FaceAnimator::basis() const {
  return bound_->basis;
}

double FaceAnimator::contactClamped() const {
  double deepest = 0.0;
  for (const ContactClamp& contact : bound_->contacts) deepest = std::max(deepest, contact.clamped());
  return deepest;
}

int FaceAnimator::contactSamples() const {
  int samples = 0;
  for (const ContactClamp& contact : bound_->contacts) samples += contact.clampedSamples();
  return samples;
}

double FaceAnimator::pushed() const {
  return std::max(bound_->order->pushed(), bound_->sides->pushed());
}

double FaceAnimator::keptShare() const {
  return bound_->order->keptShare();
}

std::vector<int> FaceAnimator::ignoredFAPs(const FAPFrame& frame) const {
  std::vector<int> ignored;
  if (frame.viseme.select1 != 0.0 || frame.viseme.select2 != 0.0) ignored.push_back(1);
  if (frame.expression.select1 != 0.0 || frame.expression.select2 != 0.0) ignored.push_back(2);
  for (int fap = FAPFrame::firstLowLevel; fap <= FAPFrame::count; ++fap)
    if (frame.value(fap) != 0.0 && !bound_->basis.motion(fap)) ignored.push_back(fap);
  return ignored;
}

}  // namespace mien
