#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "FaceCurves.h"
#include "ImageLandmarks.h"

namespace mien {

/// A place on the face: on a boundary curve, or between two of them.
struct FacePlace {
  std::string name;    ///< of a feature point, or ""
  double curve = 0.0;  ///< index 0 .. 28; with a fraction, that far on the way to the next curve
  double v = 0.0;      ///< radians
};

/// The place of an MPEG-4 feature point by its name, or of one that MPEG-4 has not: brow_middle (C6) and nose_bridge
/// (C9) on the midline, lower_lip_right and lower_lip_left (C23, halfway in v between 8.8 and 8.4, 8.7 and 8.3). Eye
/// corners lie between the lids.
/// @return false when the face lacks it
bool placeNamed(const FaceCurves& face, const std::string& name, FacePlace& place);

/// A place and where it is on a photograph (pixels, y down).
using PlacePair = std::pair<FacePlace, Eigen::Vector2d>;

/// The places that the 68 landmarks mark: brows, lids, nose, lips and the jaw line.
/// @return nothing, or one sentence that names the landmark that is missing or the feature point that the face lacks
std::string pairByNumber(const FaceCurves& face, const ImageLandmarks& landmarks, std::vector<PlacePair>& pairs);

/// The places of those names. @return as pairByNumber
std::string pairByName(const FaceCurves& face, const std::vector<std::string>& names, const ImageLandmarks& landmarks,
                       std::vector<PlacePair>& pairs);

}  // namespace mien
