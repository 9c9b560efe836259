#pragma once

#include "DeformationTable.h"

#include <array>
#include <string>
#include <vector>

namespace mien {

/// The side of the lip line a point lies on: 1 upper lip, -1 lower lip, 0 neither or at a mouth corner, and between.
using LipSide = double;

/// The map of the 16 regions over a face in pupil units.
///
/// Hard regions are those of the nearest centre. Smooth weights are a partition of unity that equals the hard regions
/// further than half the blending width from a border. Points near the mouth are looked up higher (upper lip) or lower
/// (lower lip) than they are, so that the two lips, which meet at one (x, y), belong to different regions and the lookup
/// stays continuous everywhere but across the lip line.
class FacialRegions {
 public:
  static constexpr int count = DeformationTable::regionCount;
  using Weights = std::array<double, count>;

  /// From the text of regions.json. @return nothing, or one sentence that says what is wrong
  std::string parse(const std::string& json);

  int version() const { return version_; }
  const std::string& name(int region) const { return names_[region - 1]; }
  const Eigen::Vector2d& centre(int region) const { return centres_[region - 1]; }

  /// The region (1 .. 16) of the mirrored face; itself on the midline.
  int mirrored(int region) const { return mirrored_[region - 1]; }

  /// The region (1 .. 16) a point belongs to.
  int nearest(const Eigen::Vector2d& point, LipSide side = 0.0) const;

  /// Non-negative, sum 1; region r at index r - 1.
  Weights weights(const Eigen::Vector2d& point, LipSide side = 0.0) const;

  /// 1 where tables are fitted, 0 beyond the face's outline, smooth between.
  double outlineWeight(const Eigen::Vector2d& point) const;

  /// 1 on the face, 0 on skin that faces backwards (z of the unit normal) behind the face (z in pupil units).
  double facingWeight(double z, double normalZ) const;

  /// The table of the mirrored face.
  DeformationTable mirrored(const DeformationTable& table) const;

 private:
  Eigen::Vector2d lookup(const Eigen::Vector2d& point, LipSide side) const;

  int version_ = 0;
  std::array<std::string, count> names_;
  std::array<Eigen::Vector2d, count> centres_;
  std::array<int, count> mirrored_{};
  double blend_ = 0.0;
  Eigen::Vector2d outlineCentre_, outlineRadii_, lipCentre_;
  double outlineExponent_ = 0.0, outlineFade_ = 0.0;
  double lipHalfWidth_ = 0.0, lipReach_ = 0.0, lipShift_ = 0.0;
  std::array<double, 2> depthRange_{}, normalRange_{};
};

}  // namespace mien
