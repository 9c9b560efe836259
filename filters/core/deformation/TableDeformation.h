#pragma once

#include <cstdint>
#include <vector>

#include "FacialRegions.h"
#include "Progress.h"
#include "PupilNormalisation.h"

namespace mien {

/// What a point needs to know of the region map; sides and regions are optional (none and 0: by place).
struct DeformationPoint {
  Eigen::Vector3d position;  ///< in the face's own unit
  FaceSide side;
  int region = 0;      ///< 1 .. 16: given, whatever the place
  bool stays = false;  ///< moves with the head alone: an eyeball
};

/// How much of a table's displacement counts at a point (`place` in pupil units): 1 on the face, 0 beyond its outline,
/// behind it (ears, neck) and for points that stay.
double coverageOf(const FacialRegions& regions, const Eigen::Vector3d& place, const DeformationPoint& point);

/// Whether tables are fitted to a point: within the face's outline and not behind it, nor one that stays.
bool isFitted(const FacialRegions& regions, const Eigen::Vector3d& place, const DeformationPoint& point);

/// Moves the points of one face by tables; the weights of the regions are computed once.
///
/// p' = p + strength c(p) sum_r w_r(p) (M_r(q) - q), with weights w of FacialRegions, c fading to 0 outside the
/// fitted points, and q = p but for points beyond the outline, which follow it (FacialRegions::followed). The length of
/// the sum is limited to 1.5 times the largest fitted displacement, because quadratics run away where they were not
/// fitted. A table that does not say what it was fitted to (largestDisplacement 0) is believed within 0.6 of a region's
/// centre and 1.2 of the midline, and fades to nothing at 1.1 and 2. z is carried along unchanged.
class TableDeformation {
 public:
  static constexpr double displacementLimit = 1.5;

  /// Where `progress` says stop, the points that are left get no place.
  TableDeformation(const std::vector<DeformationPoint>& points, const PupilNormalisation& pupils,
                   const FacialRegions& regions, bool smooth, const Progress& progress = {});

  std::size_t size() const { return places_.size(); }

  /// Displacements (x and y in the face's own unit; z is 0) of points begin .. end - 1. `limit` is the largest fitted
  /// displacement, pupil units. May be called from several threads.
  void displacements(const DeformationTable& table, double limit, double strength, std::size_t begin, std::size_t end,
                     Eigen::Vector2d* result) const;

 private:
  struct Place {
    Eigen::Vector2d point;  ///< whose movement it follows, pupil units
    double coverage;
    std::uint32_t first;  ///< of its shares
    std::uint32_t count;
  };
  struct Share {
    double weight;
    double nearWeight;  ///< fading beyond the middle of the region, for tables whose points are not known
    int region;         ///< from 0
  };
  void addShare(const FacialRegions& regions, const Eigen::Vector2d& point, int region, double weight);

  std::vector<Place> places_;
  std::vector<Share> shares_;
  Eigen::Matrix2d toFace_;  ///< pupil units to the face's own unit
};

/// The largest displacement a table was fitted to; where the table does not say, the largest within 0.4 of the regions'
/// centres (pupil units).
double fittedDisplacement(const DeformationTable& table, const FacialRegions& regions);

}  // namespace mien
