#include "MotionBasis.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "FAPTable.h"
#include "ProfileSettlement.h"

namespace mien {

/// A part of the table with its weights at the samples of the face.
struct MotionBasis::BoundPart {
  const AnimationEntry* entry;
  const AnimationPart* part;
  Eigen::VectorXd weights;
  std::vector<double> places;  ///< where it is to have weight 1 exactly, in samples
  Eigen::MatrixXd conditions;  ///< cardinal weights there
  bool parts;                  ///< moves one side of a contact only
  int axis;                    ///< 0, 1 or 2: the direction in which it moves most

  void setPlaces(const std::vector<double>& along, int k) {
    conditions.resize(static_cast<Eigen::Index>(along.size()), k);
    for (size_t i = 0; i < along.size(); ++i) {
      conditions.row(static_cast<Eigen::Index>(i)) = cardinalWeights(k, along[i]).transpose();
      places.push_back(along[i] * k / (2.0 * M_PI));
    }
  }
  bool isRelated() const { return !entry->replaces.empty() || !entry->beyond.empty(); }
  bool settlesAlone() const { return isRelated() || part->profile.followsGap(); }
  bool moves(int curve) const {
    return std::find(part->curves.begin(), part->curves.end(), curve) != part->curves.end();
  }
};

namespace {

int mainAxis(const AnimationPart& part) {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& slope : part.slopes) size = size.cwiseMax(slope.cwiseAbs());
  int axis = 0;
  size.maxCoeff(&axis);
  return axis;
}

bool movesOneSide(const AnimationPart& part, const std::vector<ContactPair>& contacts) {
  const auto has = [&](int curve) { return std::count(part.curves.begin(), part.curves.end(), curve) > 0; };
  return std::any_of(contacts.begin(), contacts.end(), [&](const auto& c) { return has(c.upper) != has(c.lower); });
}

/// How far a curve between a moved one and a resting one follows, by its height.
double followerShare(const ClosedCurves& curves, FollowerShape shape, int moved, int resting, int curve, int j) {
  const double from = curves.curve(resting)(j, 1), to = curves.curve(moved)(j, 1);
  const bool apart = std::abs(to - from) >= 1e-6;
  const double share = apart ? std::clamp((curves.curve(curve)(j, 1) - from) / (to - from), 0.0, 1.0)
                             : double(curve - resting) / (moved - resting);
  return shape == FollowerShape::Smooth ? share * share * (3.0 - 2.0 * share) : share;
}

/// The weights of a part on any curve: its own, those that follow, or 0.
Eigen::VectorXd weightsOnCurve(const AnimationPart& part, const Eigen::VectorXd& weights, const ClosedCurves& curves,
                               int curve) {
  const int first = part.curves.front(), last = part.curves.back();
  if (std::count(part.curves.begin(), part.curves.end(), curve)) return weights;
  const bool follows = (curve < first && part.above >= 0 && curve > part.above) || (curve > last && curve < part.below);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(weights.size());
  for (int j = 0; follows && j < weights.size(); ++j)
    result[j] = weights[j] * (curve < first ? followerShare(curves, part.follow, first, part.above, curve, j)
                                            : followerShare(curves, part.follow, last, part.below, curve, j));
  return result;
}

/// The feature point of the FAP, if the part moves it, and every other exact knot, along v.
std::vector<double> exactPlaces(const FaceCurves& face, const FeaturePoint& feature, const AnimationPart& part) {
  std::vector<double> places = part.profile.exactPlaces(face, part.curves);
  if (std::count(part.curves.begin(), part.curves.end(), feature.curve)) places.push_back(feature.v);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::string named(int fap, const std::string& fault) {
  return "animation table: FAP " + std::to_string(fap) + ": " + fault;
}

}  // namespace

double FAPMotion::reach(double value) const {
  double furthest = 0.0;
  for (const ClosedCurves::Points& slope : slopes) {
    Eigen::RowVector3d travel = Eigen::RowVector3d::Zero();
    for (int k = 0; k < intervals.intervals(); ++k) travel += intervals.length(k, value) * slope.row(k);
    furthest = std::max(furthest, travel.norm());
  }
  return furthest;
}

std::string MotionBasis::collectParts(const FaceCurves& face, const AnimationTable& table, BoundParts& parts) {
  for (const AnimationEntry& entry : table.entries()) {
    const std::string id(fapDefinition(entry.fap).featurePoint);
    const FeaturePoint* feature = face.feature(id);
    if (!feature && entry.optional) continue;
    if (!feature) return named(entry.fap, "the face has no feature point " + id + ", which this FAP moves");
    bool found = false;
    for (const AnimationPart& part : entry.parts) {
      BoundPart bound{&entry, &part, {}, {}, {}, movesOneSide(part, table.contacts()), mainAxis(part)};
      const std::string fault = part.profile.sample(face, *feature, bound.weights);
      if (!fault.empty()) return named(entry.fap, fault);
      bound.setPlaces(exactPlaces(face, *feature, part), face.curves.pointsPerCurve);
      found = found || bound.moves(feature->curve);
      parts.push_back(bound);
    }
    if (!found)
      return named(entry.fap, "its feature point " + id + " lies on " + FaceLayout::curveName(feature->curve) +
                                  ", a curve that none of its parts moves");
  }
  return {};
}

void MotionBasis::settleAlone(BoundPart& part) {
  ProfileSettlement alone = ProfileSettlement::alone();
  alone.share({alone.add(part.weights, part.conditions, part.places, part.parts)});
  alone.settle();
  part.weights = alone.weights(0);
}

/// Parts of one group that move one curve in one direction share its points.
void MotionBasis::settleTogether(BoundParts& parts) {
  ProfileSettlement together = ProfileSettlement::together();
  std::vector<size_t> partOf;
  std::map<std::tuple<std::string, int, int>, std::vector<int>> sharing;
  for (size_t i = 0; i < parts.size(); ++i) {
    const BoundPart& part = parts[i];
    if (part.settlesAlone()) continue;
    const int number = together.add(part.weights, part.conditions, part.places, part.parts);
    partOf.push_back(i);
    const bool alone = part.entry->group.empty();
    const std::string group = alone ? "FAP " + std::to_string(part.entry->fap) : part.entry->group;
    for (int curve : part.part->curves) sharing[{group, part.axis, curve}].push_back(number);
  }
  for (const auto& [key, profiles] : sharing) together.share(profiles);
  together.settle();
  for (size_t p = 0; p < partOf.size(); ++p) parts[partOf[p]].weights = together.weights(static_cast<int>(p));
}

int MotionBasis::groupNumber(const std::string& name) {
  if (name.empty()) return -1;
  const auto at = std::find(groups_.begin(), groups_.end(), name);
  const int number = static_cast<int>(at - groups_.begin());
  if (at == groups_.end()) {
    groups_.push_back(name);
    pointsOfGroup_.emplace_back();
  }
  return number;
}

/// Leaves out the samples that no interval moves: from a row for every sample to one for every sample moved.
void MotionBasis::keepMovedRows(FAPMotion& motion) {
  const Eigen::Index samples = motion.perValue.front().rows();
  for (Eigen::Index row = 0; row < samples; ++row) {
    const auto moves = [row](const ClosedCurves::Points& field) { return !field.row(row).isZero(0.0); };
    if (std::any_of(motion.perValue.begin(), motion.perValue.end(), moves))
      motion.rows.push_back(static_cast<int>(row));
  }
  for (ClosedCurves::Points& field : motion.perValue) {
    ClosedCurves::Points kept(motion.rows.size(), 3);
    for (size_t i = 0; i < motion.rows.size(); ++i) kept.row(i) = field.row(motion.rows[i]);
    motion.lengths.push_back(kept.rowwise().norm());
    field = std::move(kept);
  }
}

/// Adds the displacements of one part to those of every sample; `slopes` are mm for one FAP value, a row per interval.
void MotionBasis::addPart(const BoundPart& part, const ClosedCurves& curves, const ClosedCurves::Points& slopes,
                          FAPMotion& motion) {
  const int k = curves.pointsPerCurve;
  motion.slopes.push_back(slopes);
  for (int curve = 0; curve < curves.count; ++curve) {
    const Eigen::VectorXd weights = weightsOnCurve(*part.part, part.weights, curves, curve);
    weights_.try_emplace({motion.fap, curve}, Eigen::VectorXd::Zero(k)).first->second += weights;
    for (int j = 0; j < k; ++j) {
      if (weights[j] == 0.0) continue;
      for (int i = 0; i < slopes.rows(); ++i) motion.perValue[i].row(curve * k + j) += weights[j] * slopes.row(i);
      if (motion.group >= 0 && part.moves(curve)) pointsOfGroup_[motion.group].push_back(curve * k + j);
    }
  }
}

void MotionBasis::buildMotion(const AnimationEntry& entry, const BoundParts& parts, const ClosedCurves& curves,
                              double unit) {
  const int intervals = entry.intervals.intervals();
  FAPMotion motion{entry.fap, groupNumber(entry.group), entry.intervals, {}, {}, {}};
  motion.perValue.assign(intervals, ClosedCurves::Points::Zero(curves.points.rows(), 3));
  for (const BoundPart& part : parts) {
    if (part.entry != &entry) continue;
    ClosedCurves::Points slopes(intervals, 3);
    for (int i = 0; i < intervals; ++i) slopes.row(i) = unit * part.part->slopes[i].transpose();
    addPart(part, curves, slopes, motion);
  }
  keepMovedRows(motion);
  if (!motion.rows.empty()) motions_.push_back(std::move(motion));
}

std::string MotionBasis::bind(const FaceCurves& face, const AnimationTable& table, const FAPUnits& units) {
  *this = MotionBasis();
  BoundParts parts;
  std::string fault = collectParts(face, table, parts);
  if (!fault.empty()) return fault;
  settleTogether(parts);
  for (BoundPart& part : parts)
    if (part.isRelated() && !part.part->profile.followsGap()) settleAlone(part);
  for (const AnimationEntry& entry : table.entries())
    buildMotion(entry, parts, face.curves, units.perValue(fapDefinition(entry.fap).unit));
  for (std::vector<int>& points : pointsOfGroup_) {
    const std::set<int> once(points.begin(), points.end());
    points.assign(once.begin(), once.end());
  }
  return {};
}

const FAPMotion* MotionBasis::motion(int fap) const {
  const auto found = std::find_if(motions_.begin(), motions_.end(), [&](const auto& m) { return m.fap == fap; });
  return found == motions_.end() ? nullptr : &*found;
}

Eigen::VectorXd MotionBasis::weights(int fap, int curve) const {
  const auto found = weights_.find({fap, curve});
  return found == weights_.end() ? Eigen::VectorXd() : found->second;
}

double MotionBasis::usableValue(const FAPFrame& frame, int fap) {
  const double value = frame.value(fap);
  return std::isfinite(value) ? std::clamp(value, -largestValue, largestValue) : 0.0;
}

}  // namespace mien
