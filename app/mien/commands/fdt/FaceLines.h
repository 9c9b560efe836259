#pragma once

#include <QPolygonF>
#include <vector>

#include "FacialRegions.h"

namespace mien {

/// z of what is still seen of a face from the front, pupil units.
constexpr double furthestBack = -1.6;

/// Lines of the generic face as seen from the front, in pupil units: the parts within the face's outline.
struct FaceLines {
  std::vector<QPolygonF> curves;    ///< its boundary curves
  std::vector<QPolygonF> features;  ///< brows, lids, nose and lips
};

FaceLines genericFaceLines(const FacialRegions& regions);

}  // namespace mien
