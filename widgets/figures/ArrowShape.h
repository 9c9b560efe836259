#pragma once

#include <QPolygonF>

namespace mien {

/// An arrow as one filled polygon in figure units: seven corners, the first and the last beside the tail, the fourth
/// the tip. From tail to tip it is exactly as long as asked; short arrows are small in all directions.
QPolygonF arrowShape(const QPointF& tail, const QPointF& tip);

}  // namespace mien
