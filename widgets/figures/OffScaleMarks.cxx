#include "OffScaleMarks.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "FigureTheme.h"

namespace mien {

namespace {

constexpr double markHalfWidth = 2.2, markHeight = 3.8;  // pt

}  // namespace

bool OffScaleMarks::areNeeded(const Chart& chart) {
  if (!chart.y.end) return false;
  return std::any_of(chart.series.begin(), chart.series.end(), [&](const ChartSeries& series) {
    return series.kind != ChartSeries::Kind::Bars && std::any_of(series.y.begin(), series.y.end(), [&](double value) {
             return std::isfinite(value) && value > *chart.y.end;
           });
  });
}

/// Upwards alone: a line that comes back has been marked where it left.
void OffScaleMarks::paint(QPainter& painter, const QPolygonF& line, const QRectF& plot, const QColor& color) {
  for (int i = 0; i + 1 < line.size(); ++i) {
    const QPointF a = line[i], b = line[i + 1];
    if (!(a.y() >= plot.top() && b.y() < plot.top())) continue;
    const double x = a.x() + (a.y() - plot.top()) / (a.y() - b.y()) * (b.x() - a.x());
    if (x >= plot.left() && x <= plot.right()) paintOne(painter, QPointF(x, plot.top()), color);
  }
}

void OffScaleMarks::paintOne(QPainter& painter, const QPointF& tip, const QColor& color) {
  const QPointF down(0.0, figureUnitsFromPoints(markHeight)), aside(figureUnitsFromPoints(markHalfWidth), 0.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF() << tip << tip + down + aside << tip + down - aside);
}

}  // namespace mien
