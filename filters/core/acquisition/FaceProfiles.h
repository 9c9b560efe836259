#pragma once

#include <array>

#include "FaceLandmarks.h"
#include "MonotoneInterpolant.h"

namespace mien {

/// At which height each of the 29 boundary curves runs around the head.
///
/// Ten key curves follow landmarks (forehead, brows, both lids, nose tip and base, three lip lines, jaw); the others
/// divide the space between two keys in fixed proportions, so that curves cannot cross. Behind 45 degrees of azimuth
/// all blend into even spacing between the top of the forehead and the angles of the jaw.
class FaceProfiles {
 public:
  explicit FaceProfiles(const FaceLandmarks& landmarks);

  const HeadAxis& axis() const { return axis_; }

  /// Height (mm) of a curve (0 .. 28) at an azimuth (radians).
  double height(int curve, double azimuth) const;

  /// Radius (mm) of the closed lips' contact line, from the landmarks; valid between the mouth corners.
  double lipRadius(double azimuth) const { return lipRadius_(azimuth); }

  /// How much a curve at this azimuth lies on the lips' contact line: 1 between the mouth corners, 0 beside the mouth.
  double lipWeight(double azimuth) const;

 private:
  static constexpr int keyCount = 10;
  double frontHeight(int curve, double azimuth) const;

  HeadAxis axis_;
  std::array<MonotoneInterpolant, keyCount> keys_;
  MonotoneInterpolant lipRadius_;
  double rightCorner_ = 0.0, leftCorner_ = 0.0;  ///< azimuths of the mouth corners
  double top_ = 0.0, bottom_ = 0.0;              ///< heights of C1 and C28 at the back
};

}  // namespace mien
