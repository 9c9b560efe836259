#pragma once

#include "RadialSkin.h"

namespace mien {

/// The skin as seen from the axis with its ears taken off: a smooth head behind the cheeks, exact in front.
///
/// Behind 80 degrees of azimuth the radius comes from a map that has been opened (minimum, then maximum over a window wider
/// than an ear) along the azimuth and smoothed; before 60 degrees it is that of the mesh; between, both are blended.
class EarlessSkin {
 public:
  /// Maps the heights `low` .. `high` (mm).
  EarlessSkin(const RadialSkin& skin, double low, double high);

  const HeadAxis& axis() const { return skin_.axis(); }

  /// Radius in mm, NaN where the mesh has no skin.
  double radius(double azimuth, double y) const;

 private:
  double mapped(double azimuth, double y) const;

  const RadialSkin& skin_;
  double low_;
  Eigen::MatrixXd map_;  ///< rows: heights, columns: azimuths from -pi
};

}  // namespace mien
