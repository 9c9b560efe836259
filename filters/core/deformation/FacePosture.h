#pragma once

#include <vector>

#include "TableDeformation.h"

namespace mien {

/// Whether the points of a face stand on their head in its pupil units, as they do when its pupils are exchanged: what
/// lies 0.4 to 1.6 above the eyes then comes forward further, by the nose, than what lies as far below. A face whose
/// points say neither is upright.
bool standsOnItsHead(const std::vector<DeformationPoint>& points, const PupilNormalisation& pupils);

}  // namespace mien
