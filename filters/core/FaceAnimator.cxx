#include "FaceAnimator.h"

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

// Owners of a sample that are no number of a group; -1 is a FAP without a group.
constexpr int nobody = -2, several = -3;

}  // namespace

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
  binding->owners.resize(binding->neutral.curves.points.rows());
  bound_ = std::move(binding);
  return {};
}

/// Notes which group moves a sample: only what a single group moves is bound by its displacements alone.
void FaceAnimator::claimRows(const FAPMotion& motion) {
  for (int row : motion.rows) {
    int& owner = bound_->owners[row];
    owner = owner == nobody || owner == motion.group ? motion.group : several;
  }
}

/// @return whether anything moves
bool FaceAnimator::displace(const FAPFrame& frame) {
  ClosedCurves::Points& points = bound_->animated.points;
  points = bound_->neutral.curves.points;
  std::fill(bound_->owners.begin(), bound_->owners.end(), nobody);
  bool moved = false;
  for (const FAPMotion& motion : bound_->basis.motions()) {
    const double value = MotionBasis::usableValue(frame, motion.fap);
    if (value == 0.0) continue;
    moved = true;
    for (int i = 0; i < motion.intervals.intervals(); ++i) {
      const double length = motion.intervals.length(i, value);
      if (length == 0.0) continue;
      for (size_t r = 0; r < motion.rows.size(); ++r) points.row(motion.rows[r]) += length * motion.perValue[i].row(r);
    }
    claimRows(motion);
  }
  return moved;
}

/// Height comes first, as contact depends on it: the shift along x and z gives way where both together would
/// take a point of a group further than the largest single displacement.
void FaceAnimator::limitGroups(const FAPFrame& frame) {
  const MotionBasis& basis = bound_->basis;
  for (int group = 0; group < static_cast<int>(basis.groups().size()); ++group) {
    double largest = 0.0;
    for (const FAPMotion& motion : basis.motions())
      if (motion.group == group) largest = std::max(largest, motion.reach(MotionBasis::usableValue(frame, motion.fap)));
    for (int row : basis.pointsOfGroup(group)) {
      if (bound_->owners[row] != group) continue;
      const Eigen::RowVector3d start = bound_->neutral.curves.points.row(row);
      Eigen::RowVector3d shift = bound_->animated.points.row(row) - start;
      const double level = std::hypot(shift.x(), shift.z());
      const double allowed = std::sqrt(std::max(0.0, largest * largest - shift.y() * shift.y()));
      if (level <= allowed * (1.0 + 1e-12) || level <= 1e-9) continue;
      bound_->animated.points(row, 0) = start.x() + shift.x() * allowed / level;
      bound_->animated.points(row, 2) = start.z() + shift.z() * allowed / level;
    }
  }
}

const ClosedCurves& FaceAnimator::animate(const FAPFrame& frame) {
  const bool moved = displace(frame);
  for (ContactClamp& contact : bound_->contacts) contact.reset();
  bound_->order->reset();
  if (!moved) return bound_->animated;
  for (ContactClamp& contact : bound_->contacts) contact.apply(frame, bound_->animated);
  limitGroups(frame);
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
  return bound_->order->pushed();
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
