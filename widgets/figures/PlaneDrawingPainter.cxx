#include "PlaneDrawingPainter.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "TextLines.h"

namespace mien {

namespace {

constexpr double marginShare = 0.04;  // of the shown part, on every side: strokes and labels at the edge
constexpr double arrowLength = 5.0, arrowHalfWidth = 1.9;  // pt
constexpr double headShare = 0.5;                          // of a short arrow
constexpr double labelGap = 1.5;                           // pt, between a point and its label
constexpr double haloWidth = 1.6;                          // pt, around a label

QPen penOf(const PlaneStroke& stroke, const FigureTheme& theme) {
  if (stroke.width <= 0.0) return Qt::NoPen;  // Qt draws a hairline
  QPen pen(stroke.color.isValid() ? theme.own(stroke.color) : theme.text, figureUnitsFromPoints(stroke.width));
  pen.setJoinStyle(Qt::RoundJoin);
  pen.setCapStyle(Qt::RoundCap);
  if (stroke.dashed) pen.setDashPattern({4.0, 3.0});
  return pen;
}

QRectF grown(const QRectF& shown) {
  const double margin = marginShare * std::max(shown.width(), shown.height());
  return shown.adjusted(-margin, -margin, margin, margin);
}

QPolygonF arrowHead(const QPointF& tail, const QPointF& tip) {
  const double length = std::max(std::hypot(tip.x() - tail.x(), tip.y() - tail.y()), 1e-9);
  const double head = std::min(figureUnitsFromPoints(arrowLength), headShare * length);
  const QPointF along = (tip - tail) / length, across(-along.y(), along.x()), base = tip - head * along;
  const QPointF side = arrowHalfWidth / arrowLength * head * across;
  return QPolygonF({tip, base + side, base - side});
}

/// The last point of a line that is a head's length before its tip, so that many short pieces have a whole head.
QPointF tailBefore(const QPolygonF& points) {
  const QPointF tip = points.last();
  for (int i = points.size() - 2; i > 0; --i)
    if (std::hypot(tip.x() - points[i].x(), tip.y() - points[i].y()) >= figureUnitsFromPoints(2.0 * arrowLength))
      return points[i];
  return points.first();
}

/// The text's outline under the text, which stays text in the file. A page without a colour of its own is white.
void paintHalo(QPainter& painter, const FigureTheme& theme, const QFont& font, const QPointF& place,
               const QString& text) {
  QPainterPath outline;
  outline.addText(place, font, text);
  const QColor background = theme.background.isValid() ? theme.background : QColor(Qt::white);
  painter.strokePath(
      outline, QPen(background, figureUnitsFromPoints(2.0 * haloWidth), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

}  // namespace

PlaneDrawingPainter::PlaneDrawingPainter(const PlaneDrawing& drawing, const QRectF& place,
                                         const std::optional<QRectF>& shown, Margin margin)
    : drawing_(drawing) {
  const QRectF all = shown.value_or(drawing.bounds()), part = margin == Margin::Around ? grown(all) : all;
  scale_ = std::min(place.width() / std::max(part.width(), 1e-9), place.height() / std::max(part.height(), 1e-9));
  origin_ = place.center() - QPointF(scale_ * part.center().x(), -scale_ * part.center().y());
}

QPointF PlaneDrawingPainter::position(const QPointF& plane) const {
  return origin_ + QPointF(scale_ * plane.x(), -scale_ * plane.y());
}

void PlaneDrawingPainter::paintLine(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Line& line) const {
  QPolygonF points;
  for (const QPointF& point : line.points) points << position(point);
  painter.setPen(penOf(line.stroke, theme));
  painter.setBrush(line.stroke.fill.isValid() ? QBrush(theme.own(line.stroke.fill)) : QBrush(Qt::NoBrush));
  if (line.closed || line.stroke.fill.isValid())
    painter.drawPolygon(points);
  else
    painter.drawPolyline(points);
  if (!line.arrow || points.size() < 2) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(line.stroke.color.isValid() ? theme.own(line.stroke.color) : theme.text);
  painter.drawPolygon(arrowHead(tailBefore(points), points.last()));
}

void PlaneDrawingPainter::paintMark(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Mark& mark) const {
  painter.setPen(penOf(mark.stroke, theme));
  painter.setBrush(mark.stroke.fill.isValid() ? QBrush(theme.own(mark.stroke.fill)) : QBrush(Qt::NoBrush));
  const double radius = figureUnitsFromPoints(mark.radius);
  painter.drawEllipse(position(mark.at), radius, radius);
}

void PlaneDrawingPainter::paintLabel(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Label& label,
                                     bool halo) const {
  const QFont font = figureFont(label.size, label.bold);
  const double width = textWidth(font, label.text), gap = figureUnitsFromPoints(labelGap);
  QPointF place = position(label.at);
  place.ry() += 0.36 * font.pixelSize();  // the middle of capitals at the point
  const Qt::Alignment alignment(label.alignment);
  if (alignment & Qt::AlignLeft) place.rx() += gap;
  if (alignment & Qt::AlignRight) place.rx() -= width + gap;
  if (alignment & Qt::AlignHCenter) place.rx() -= 0.5 * width;
  if (alignment & Qt::AlignTop) place.ry() += 0.5 * font.pixelSize() + gap;
  if (alignment & Qt::AlignBottom) place.ry() -= 0.5 * font.pixelSize() + gap;
  if (halo) return paintHalo(painter, theme, font, place, label.text);
  painter.setFont(font);
  painter.setPen(label.color.isValid() ? theme.own(label.color) : theme.text);
  painter.drawText(place, label.text);
}

void PlaneDrawingPainter::paint(QPainter& painter, const FigureTheme& theme) const {
  for (const PlaneDrawing::Line& line : drawing_.lines) paintLine(painter, theme, line);
  for (const PlaneDrawing::Label& label : drawing_.labels)
    if (label.halo) paintLabel(painter, theme, label, true);  // under the marks, which stay whole
  for (const PlaneDrawing::Mark& mark : drawing_.marks) paintMark(painter, theme, mark);
  for (const PlaneDrawing::Label& label : drawing_.labels) paintLabel(painter, theme, label, false);
}

PlatePanel drawingPanel(const std::string& heading, const PlaneDrawing& drawing, const std::optional<QRectF>& shown) {
  const QRectF part = grown(shown.value_or(drawing.bounds()));
  const auto paint = [drawing, shown](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    painter.setClipRect(place);
    PlaneDrawingPainter(drawing, place, shown).paint(painter, theme);
  };
  return {heading, 1, part.height() / std::max(part.width(), 1e-9), paint};
}

}  // namespace mien
