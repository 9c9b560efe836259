#pragma once

#include <vector>

#include "FaceCurves.h"
#include "FaceLandmarks.h"

namespace mien {

/// Addresses (curve, v) of the MPEG-4 feature points that lie on the face's surface (ISO/IEC 14496-2, table of feature
/// points).
///
/// A point on the midline has v = pi. Of a pair, v solves x(v) = +-x on the curve's trigonometric interpolant, x being
/// the pair's mean distance from the midline; the two addresses are v and 2 pi - v exactly.
std::vector<FeaturePoint> locateFeatures(const ClosedCurves& curves, const FaceLandmarks& landmarks);

}  // namespace mien
