#pragma once

#include <QPolygonF>
#include <vector>

#include "FaceCurves.h"
#include "PlaneDrawing.h"

namespace mien {

/// The frontal half of a face's curves as lines, in mm or, given the pupils, in pupil units.
std::vector<QPolygonF> frontalLines(const FaceCurves& face, bool inPupilUnits);

/// The lines thin and grey, to draw on.
void addFaceBehind(PlaneDrawing& drawing, const std::vector<QPolygonF>& lines);

}  // namespace mien
