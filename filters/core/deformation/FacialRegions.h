#pragma once

#include <array>
#include <string>
#include <vector>

#include "DeformationTable.h"

namespace mien {

/// The side of the slits a point lies on: 1 upper lip (lid), -1 lower lip (lid), 0 far from both and at the corners,
/// and between.
struct FaceSide {
  double lips = 0.0;
  double lids = 0.0;
};

/// The map of the 16 regions over a face in pupil units.
///
/// Hard regions are those of the nearest centre. Smooth weights are a partition of unity that equals the hard regions
/// further than half the blending width from a border. Upper and lower lips (lids) meet at one (x, y), so they are told
/// apart by their side: on the upper side the regions of the lower lip count as further away by the slit's separation
/// times the side, and the other way round; regions of both sides count as further away by the slit's aside times the
/// side, as one map cannot follow two lips that part. Weights are continuous wherever sides are, which is everywhere
/// but across a slit.
class FacialRegions {
 public:
  static constexpr int count = DeformationTable::regionCount;
  using Weights = std::array<double, count>;

  /// Lips or lids: what belongs to one side only.
  struct Slit {
    double reach = 0.0, separation = 0.0;  ///< pupil units
    double aside = 0.0;                    ///< how much further away regions of both sides count beside it, pupil units
    std::array<double, count> sides{};     ///< of each region: 1 upper, -1 lower, 0 both
  };

  /// From the text of regions.json.
  /// @param[out] faultLine the line of a fault in the JSON itself, 0 for none or any other
  /// @return nothing, or one sentence that says what is wrong
  std::string parse(const std::string& json, int* faultLine = nullptr);

  int version() const { return version_; }
  const std::string& name(int region) const { return names_[region - 1]; }
  const Eigen::Vector2d& centre(int region) const { return centres_[region - 1]; }

  /// The region (1 .. 16) of the mirrored face; itself on the midline.
  int mirrored(int region) const { return mirrored_[region - 1]; }

  /// The region (1 .. 16) a point belongs to.
  int nearest(const Eigen::Vector2d& point, const FaceSide& side = {}) const;

  /// Non-negative, sum 1; region r at index r - 1.
  Weights weights(const Eigen::Vector2d& point, const FaceSide& side = {}) const;

  /// How far from the lips (lids) their sides reach, along the surface, pupil units.
  double lipReach() const { return lips_.reach; }
  double lidReach() const { return lids_.reach; }

  /// Whether a point lies within the face's outline, where tables are fitted.
  bool covers(const Eigen::Vector2d& point) const { return this->outlineRadius(point) <= 1.0; }

  /// 1 on the face, 0 far beyond its outline, smooth between.
  double outlineWeight(const Eigen::Vector2d& point) const;

  /// The place whose movement a point follows: itself on the face, and beyond the outline the place on it in the
  /// direction of the outline's centre, because quadratics run away from the points they were fitted to. Smooth.
  Eigen::Vector2d followed(const Eigen::Vector2d& point) const;

  /// 1 on the face, 0 behind it, where the ears are: z in pupil units, smooth between.
  double depthWeight(double z) const;

  /// The table of the mirrored face.
  DeformationTable mirrored(const DeformationTable& table) const;

 private:
  struct Reader;

  /// Half a superellipse about the outline's centre.
  struct HalfOutline {
    double radius = 0.0, exponent = 0.0;  ///< along y
  };

  /// 0 at the outline's centre, 1 on it.
  double outlineRadius(const Eigen::Vector2d& point) const;
  Weights distances(const Eigen::Vector2d& point, const FaceSide& side) const;

  int version_ = 0;
  std::array<std::string, count> names_;
  std::array<Eigen::Vector2d, count> centres_;
  std::array<int, count> mirrored_{};
  double blend_ = 0.0;
  Eigen::Vector2d outlineCentre_;
  double outlineAside_ = 0.0;  ///< its radius along x
  HalfOutline above_, below_;  ///< of its centre
  double outlineBegin_ = 1.0, outlineFade_ = 0.0;
  Slit lips_, lids_;
  std::array<double, 2> depthRange_{};
};

}  // namespace mien
