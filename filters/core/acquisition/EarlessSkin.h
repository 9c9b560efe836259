#pragma once

#include "RadialSkin.h"

namespace mien {

/// The skin as seen from the axis with its ears taken off: a smooth head in their place, exact elsewhere.
///
/// Ears are what stands out by 2.5 mm or more from a map that has been opened (minimum, then maximum over a window
/// wider than an ear) along the azimuth; there, and behind holes too large to be filled, the radius comes from that
/// map, smoothed. In front of 60 degrees of azimuth it is always that of the mesh, from 80 degrees on ears are taken
/// off wholly.
class EarlessSkin {
 public:
  /// Maps the heights `low` .. `high` (mm).
  EarlessSkin(const RadialSkin& skin, double low, double high);

  const HeadAxis& axis() const { return skin_.axis(); }

  /// Radius in mm, NaN where the mesh has no skin.
  double radius(double azimuth, double y) const;

 private:
  double mapped(const Eigen::MatrixXd& map, double azimuth, double y) const;

  const RadialSkin& skin_;
  double low_;
  Eigen::MatrixXd map_;   ///< radii; rows: heights, columns: azimuths from -pi
  Eigen::MatrixXd ears_;  ///< how much of a place belongs to an ear, 0 .. 1
};

}  // namespace mien
