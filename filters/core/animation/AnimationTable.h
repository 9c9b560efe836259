#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "FaceLayout.h"
#include "PiecewiseLinear.h"
#include "WeightProfile.h"

namespace mien {

/// How the curves between a moved one and a resting one follow, with s the share of the way by height, 1 at the moved
/// one.
enum class FollowerShape {
  Linear,  ///< s: keeps the order of the curves as long as the outer two keep theirs
  Smooth   ///< s^2 (3 - 2 s): no edge across the skin at either end
};

/// Some curves that one FAP moves alike, and how the neighbours follow.
struct AnimationPart {
  std::vector<int> curves;  ///< indices, moved with the weights of the profile
  int above = -1;           ///< curves between this one and the first moved follow by height; -1: none
  int below = -1;           ///< the same between the last moved one and this
  FollowerShape follow = FollowerShape::Linear;
  WeightProfile profile;
  std::vector<Eigen::Vector3d> slopes;  ///< per interval, in FAP units (x left, y up, z forward)
};

/// A share of a FAP's value that another FAP takes over as far as it is not set itself.
struct FAPLoan {
  int fap = 0;  ///< who takes it
  double share = 0.0;
};

/// What one FAP does. Unit, direction and feature point are those of the standard (FAPTable.h).
struct AnimationEntry {
  int fap = 0;
  std::string group;          ///< FAPs of one group share its points: their weights sum to at most 1
  bool optional = false;      ///< left out on a face without its feature point, where other entries are refused
  std::vector<int> replaces;  ///< FAPs whose motion at its feature point gives way to its own (EffectiveValues)
  std::vector<int> beyond;    ///< FAPs that move the same place: it adds what it asks for beyond them
  std::vector<FAPLoan> lends;
  PiecewiseLinear intervals;
  std::vector<AnimationPart> parts;
};

/// Two curves that may touch but not cross.
struct ContactPair {
  std::string name;
  int upper = 0, lower = 0;
  bool upperYields = false;  ///< the upper stops at the lower (lids); else both give way (lips)
};

/// Neighbouring curves, first to last, whose samples keep their order from the middle of the face outwards (SideOrder).
struct CurveBand {
  int first = 0, last = 0;
};

/// The face animation table (FAT) [S 5]: which points of the boundary curves each FAP moves, and how far.
///
/// Read from JSON: {"format": "mien animation table", "version": 3, "contacts": [...], "faps": [...]}, see
/// doc/animation_table.md; tables of version 1, which had no relations between FAPs, and 2 without "follow" are read
/// too. Points are addressed by curve and by feature points along v, never by sample, so one table serves every face
/// and every K >= 32.
class AnimationTable {
 public:
  static constexpr int version = 3;

  /// Replaces the table; on a fault it stays as it was.
  /// @return nothing, or one sentence that names the entry and what is wrong with it
  std::string parse(const std::string& json);

  /// The line at which the last fault lay, from 1, when the text was no JSON; else 0.
  int faultLine() const { return faultLine_; }

  int fileVersion() const { return fileVersion_; }  ///< of the text read last

  const std::vector<AnimationEntry>& entries() const { return entries_; }
  const std::vector<ContactPair>& contacts() const { return contacts_; }
  const std::vector<CurveBand>& sideways() const { return sideways_; }
  const AnimationEntry* entry(int fap) const;  ///< or nullptr

 private:
  std::vector<AnimationEntry> entries_;
  std::vector<ContactPair> contacts_;
  std::vector<CurveBand> sideways_;
  int faultLine_ = 0, fileVersion_ = version;
};

}  // namespace mien
