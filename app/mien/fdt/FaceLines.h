#pragma once

#include <QPolygonF>
#include <vector>

#include "FacialRegions.h"

namespace mien {

/// The boundary curves of the generic face as seen from the front, in pupil units: the parts within the face's outline.
std::vector<QPolygonF> genericFaceLines(const FacialRegions& regions);

}  // namespace mien
