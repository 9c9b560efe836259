#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "AnimationTable.h"
#include "FAPFrame.h"
#include "FAPUnits.h"
#include "FaceCurves.h"

namespace mien {

/// What one FAP does to the samples of one face.
struct FAPMotion {
  int fap = 0;
  int group = -1;  ///< number of the group, or -1
  PiecewiseLinear intervals;
  std::vector<int> rows;                       ///< the samples it moves, as rows of ClosedCurves::points
  std::vector<ClosedCurves::Points> perValue;  ///< per interval: mm for one FAP value, a row per sample
  std::vector<Eigen::VectorXd> lengths;        ///< of the rows of perValue
  std::vector<ClosedCurves::Points> slopes;    ///< per part: mm for one FAP value at weight 1, a row per interval

  /// The furthest that this FAP alone takes any point, in mm.
  double reach(double value) const;
};

/// An animation table bound to a face: a sparse displacement field per FAP and interval. Linear, so that
/// a frame is a few scaled additions.
class MotionBasis {
 public:
  /// Largest FAP value that is followed; what lies beyond is absurd and only risks overflow.
  static constexpr double largestValue = 1e6;

  /// @return nothing, or one sentence that names the entry and what the face lacks
  std::string bind(const FaceCurves& face, const AnimationTable& table, const FAPUnits& units);

  const std::vector<FAPMotion>& motions() const { return motions_; }
  const std::vector<std::string>& groups() const { return groups_; }
  const FAPMotion* motion(int fap) const;

  /// The weights of a FAP on a curve (0 where it does nothing), K values.
  Eigen::VectorXd weights(int fap, int curve) const;

  /// Samples on the curves that a group moves (followers left out), ascending.
  const std::vector<int>& pointsOfGroup(int group) const { return pointsOfGroup_[group]; }

  /// The value that counts: finite, and not beyond `largestValue`.
  static double usableValue(const FAPFrame& frame, int fap);

 private:
  struct BoundPart;
  using BoundParts = std::vector<BoundPart>;
  static std::string collectParts(const FaceCurves& face, const AnimationTable& table, BoundParts& parts);
  static void settleAlone(BoundPart& part);
  static void settleTogether(BoundParts& parts);
  void buildMotion(const AnimationEntry& entry, const BoundParts& parts, const ClosedCurves& curves, double unit);
  void addPart(const BoundPart& part, const ClosedCurves& curves, const ClosedCurves::Points& slopes,
               FAPMotion& motion);
  static void keepMovedRows(FAPMotion& motion);
  int groupNumber(const std::string& name);

  std::vector<FAPMotion> motions_;
  std::vector<std::string> groups_;
  std::vector<std::vector<int>> pointsOfGroup_;
  std::map<std::pair<int, int>, Eigen::VectorXd> weights_;  ///< by FAP and curve
};

}  // namespace mien
