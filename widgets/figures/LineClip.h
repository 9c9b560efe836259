#pragma once

#include <QPolygonF>
#include <QRectF>
#include <vector>

namespace mien {

/// The parts of an open polyline inside a rectangle. Done here because SVG files of Qt 5 ignore a painter's clipping.
std::vector<QPolygonF> clippedLine(const QPolygonF& line, const QRectF& rectangle);

}  // namespace mien
