#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "ClosedCurves.h"

namespace mien {

/// Where an MPEG-4 feature point lies on the face: on a curve, at a parameter v.
struct FeaturePoint {
  std::string id;  ///< MPEG-4 name such as "8.3"
  int curve = 0;   ///< index of the curve, 0 .. 28
  double v = 0.0;  ///< radians, 0 .. 2 pi
};

/// A face before the PDE: its 29 boundary curves, feature points and pupils (lengths in mm).
struct FaceCurves {
  ClosedCurves curves;
  std::vector<FeaturePoint> features;
  Eigen::Vector3d leftPupil = Eigen::Vector3d::Zero();  ///< the subject's left, +x
  Eigen::Vector3d rightPupil = Eigen::Vector3d::Zero();
  bool hasPupils = false;

  /// The feature point of that name, or nullptr.
  const FeaturePoint* feature(const std::string& id) const;
};

/// At how many places, eight for every sample, a curve lies more than 0.1 mm below the next one.
int countCrossings(const ClosedCurves& curves);

/// One sentence that says what makes the curves unusable as a face (count, NaN, too few points,
/// curves whose order down the face is crossed at some v), or nothing.
std::string describeFault(const FaceCurves& face);

}  // namespace mien
