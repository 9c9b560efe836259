#pragma once

#include <QPolygonF>
#include <QRectF>

#include "Chart.h"

class QColor;
class QPainter;

namespace mien {

/// Where lines of a chart run out of its top, because its axis has been given an end: a triangle in the line's colour,
/// its tip at the edge.
class OffScaleMarks {
 public:
  /// Whether a line of the chart has values above its axis.
  static bool areNeeded(const Chart& chart);

  /// @param line  of the chart, in figure units, y down
  static void paint(QPainter& painter, const QPolygonF& line, const QRectF& plot, const QColor& color);

  static void paintOne(QPainter& painter, const QPointF& tip, const QColor& color);
};

}  // namespace mien
