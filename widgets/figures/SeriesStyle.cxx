#include "SeriesStyle.h"

#include <QPainter>
#include <QPolygonF>
#include <cmath>

namespace mien {

namespace {

constexpr double markerRadius = 1.9;  // pt: told apart at a glance in print

/// In multiples of the line's width.
QVector<qreal> dashes(int index) {
  static const QVector<qreal> patterns[SeriesStyle::count] = {
      {}, {6.0, 2.5}, {1.5, 2.0}, {6.0, 2.0, 1.5, 2.0}, {11.0, 3.0}, {6.0, 2.0, 1.5, 2.0, 1.5, 2.0}};
  return patterns[index];
}

QPolygonF regularPolygon(const QPointF& center, double radius, int corners, double firstAngle) {
  QPolygonF polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = firstAngle + 2.0 * M_PI * i / corners;
    polygon << center + radius * QPointF(std::cos(angle), std::sin(angle));
  }
  return polygon;
}

}  // namespace

SeriesStyle::SeriesStyle(const FigureTheme& theme, int index)
    : color_(theme.series.at(((index % count) + count) % count)),
      background_(theme.background.isValid() ? theme.background : QColor(Qt::white)),
      index_(((index % count) + count) % count),
      width_(figureUnitsFromPoints(theme.lineWidth)) {}

QPen SeriesStyle::linePen(double share) const {
  QPen pen(color_, share * width_, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (index_ > 0) pen.setDashPattern(dashes(index_));
  return pen;
}

void SeriesStyle::drawMarker(QPainter& painter, const QPointF& center) const {
  const double r = figureUnitsFromPoints(markerRadius);
  painter.setPen(QPen(color_, 0.6 * width_));
  painter.setBrush(index_ % 2 == 0 ? color_ : background_);
  switch (index_) {
    case 0:
      painter.drawEllipse(center, r, r);
      break;
    case 1:
      painter.drawPolygon(regularPolygon(center, 1.3 * r, 4, M_PI / 4));
      break;
    case 2:
      painter.drawPolygon(regularPolygon(center, 1.4 * r, 3, -M_PI / 2));
      break;
    case 3:
      painter.drawPolygon(regularPolygon(center, 1.4 * r, 4, 0.0));
      break;
    case 4:
      painter.drawPolygon(regularPolygon(center, 1.4 * r, 3, M_PI / 2));
      break;
    default:
      painter.drawEllipse(center, r, r);
      break;
  }
}

}  // namespace mien
