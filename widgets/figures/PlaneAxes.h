#pragma once

#include <QRectF>
#include <QString>

#include "PlaneDrawing.h"

namespace mien {

/// Adds axes along the lower and the left edge of a part of the plane: ticks, numbers, and below them the unit.
///
/// @param range  what the axes span, y up
/// @param step   between ticks, in units of the drawing
/// @param width  of the panel that will hold the drawing, mm: it decides how much of the plane the numbers take
/// @return the part of the plane that holds the range and its axes
QRectF addPlaneAxes(PlaneDrawing& drawing, const QRectF& range, double step, const QString& unit, double width);

}  // namespace mien
