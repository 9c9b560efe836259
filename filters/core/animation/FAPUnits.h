#pragma once

#include <string>

#include "FAPUnit.h"
#include "FaceCurves.h"

namespace mien {

/// The distances of one neutral face that FAP values count in (ISO/IEC 14496-2), in mm.
struct FAPUnits {
  double irisDiameter = 0.0;         ///< IRISD: 3.1.y - 3.3.y, mean of both eyes
  double eyeSeparation = 0.0;        ///< ES: from pupil to pupil along x
  double eyeNoseSeparation = 0.0;    ///< ENS: pupil height (mean of both) - 9.15.y
  double mouthNoseSeparation = 0.0;  ///< MNS: 9.15.y - 2.2.y
  double mouthWidth = 0.0;           ///< MW: 8.3.x - 8.4.x

  /// The distance in mm; 0 for None and for Angle.
  double distance(FAPUnit unit) const;

  /// mm (or, for AU, radians) for one FAP value.
  double perValue(FAPUnit unit) const;
};

/// Measures the units at the feature points of the face, which lie between the samples as a rule.
/// @return nothing, or one sentence that names the missing feature or the unit that is not positive
std::string measureFAPUnits(const FaceCurves& face, FAPUnits& units);

}  // namespace mien
