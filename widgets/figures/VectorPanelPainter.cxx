#include "VectorPanelPainter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ArrowShape.h"
#include "LineClip.h"
#include "TextLines.h"

namespace mien {

namespace {

constexpr double vectorHeadingSize = 7.5, rowHeadingSize = 6.5, remarkSize = 7.0;  // pt
constexpr double outlineWidth = 0.7, seamWidth = 0.5;                              // pt
constexpr double landmarkWidth = 0.6;                                              // pt
constexpr double seamShare = 0.30, landmarkShare = 0.60,
                 outlineShare = 0.75;  // of the text's colour in the background's
constexpr double leastArrow = 0.25;    // mm: what is seen as a shorter arrow is a dot when it moves by more
constexpr double dotRadius = 0.22;     // mm

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto part = [&](double x, double y) { return share * x + (1.0 - share) * y; };
  return QColor::fromRgbF(part(a.redF(), b.redF()), part(a.greenF(), b.greenF()), part(a.blueF(), b.blueF()));
}

QFont headingFont(const VectorStyle& style) {
  return style.font(style.asRow ? rowHeadingSize : vectorHeadingSize);
}

QPen linePen(const QColor& color, double width) {
  return QPen(color, figureUnitsFromPoints(width), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

}  // namespace

VectorPanelPainter::Margins VectorPanelPainter::overhang(const VectorStyle& style, const Eigen::AlignedBox2d& frame,
                                                         double faceScale) const {
  VectorPanelPainter placed = *this;
  placed.place(QPointF(), frame, faceScale);
  const QRectF plot = placed.plot();
  Margins margins;
  for (const PictureArrow& arrow : picture_.arrows) {
    const QPointF tip = placed.toFigure(arrow.tail) + style.arrow(arrow);
    margins.left = std::max(margins.left, plot.left() - tip.x());
    margins.right = std::max(margins.right, tip.x() - plot.right());
    margins.top = std::max(margins.top, plot.top() - tip.y());
    margins.bottom = std::max(margins.bottom, tip.y() - plot.bottom());
  }
  return margins;
}

void VectorPanelPainter::place(const QPointF& topLeft, const Eigen::AlignedBox2d& frame, double faceScale) {
  topLeft_ = topLeft;
  frame_ = frame;
  faceScale_ = faceScale;
}

double VectorPanelPainter::headingHeight(const VectorStyle& style) const {
  return heading_.isEmpty() ? 0.0 : lineHeight(headingFont(style)) + figureUnitsFromPoints(3.0);
}

QRectF VectorPanelPainter::plot() const {
  return QRectF(topLeft_, faceScale_ * QSizeF(frame_.sizes().x(), frame_.sizes().y()));
}

QPointF VectorPanelPainter::toFigure(const Eigen::Vector2d& place) const {
  return topLeft_ + faceScale_ * QPointF(place.x() - frame_.min().x(), frame_.max().y() - place.y());
}

Eigen::Vector2d VectorPanelPainter::toFace(const QPointF& place) const {
  const QPointF from = (place - topLeft_) / faceScale_;
  return {frame_.min().x() + from.x(), frame_.max().y() - from.y()};
}

void VectorPanelPainter::paint(QPainter& painter, const VectorStyle& style, const QPointF& headingPlace) const {
  const FigureTheme& theme = style.theme;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(linePen(mixed(theme.text, theme.background, seamShare), seamWidth));
  paintLines(painter, picture_.seams);
  painter.setPen(linePen(mixed(theme.text, theme.background, landmarkShare), landmarkWidth));
  paintLines(painter, picture_.landmarks);
  painter.setPen(linePen(mixed(theme.text, theme.background, outlineShare), outlineWidth));
  paintLines(painter, picture_.outline);
  paintArrows(painter, style);
  if (picture_.arrows.empty()) paintRemark(painter, style);
  if (heading_.isEmpty()) return;
  const QFont font = headingFont(style);
  painter.setFont(font);
  painter.setPen(theme.text);
  const double left = style.asRow ? plot().center().x() - 0.5 * textWidth(font, heading_) : headingPlace.x();
  painter.drawText(QPointF(left, headingPlace.y() + 0.95 * font.pixelSize()), heading_);
}

void VectorPanelPainter::paintLines(QPainter& painter, const std::vector<VectorPicture::Line>& lines) const {
  const QRectF plot = this->plot().adjusted(-1.0, -1.0, 1.0, 1.0);  // rounding
  for (const VectorPicture::Line& line : lines) {
    QPolygonF polygon;
    for (int i = 0; i < line.rows(); ++i) polygon << toFigure(line.row(i));
    for (const QPolygonF& part : clippedLine(polygon, plot)) painter.drawPolyline(part);
  }
}

void VectorPanelPainter::paintArrows(QPainter& painter, const VectorStyle& style) const {
  painter.setPen(Qt::NoPen);
  QColor last;
  for (const PictureArrow& arrow : picture_.arrows) {
    const QColor color = style.colorOf(arrow);
    if (color != last) painter.setBrush(color);
    last = color;
    paintArrow(painter, style, arrow);
  }
}

void VectorPanelPainter::paintArrow(QPainter& painter, const VectorStyle& style, const PictureArrow& arrow) const {
  const QPointF tail = toFigure(arrow.tail), along = style.arrow(arrow);
  const bool isShort = std::hypot(along.x(), along.y()) < leastArrow * figureUnitsPerMillimetre;
  const double radius = dotRadius * figureUnitsPerMillimetre;
  if (isShort && std::abs(arrow.towards) / style.scale > 2.0 * leastArrow)
    painter.drawEllipse(tail, radius, radius);
  else
    painter.drawPolygon(arrowShape(tail, tail + along));
}

void VectorPanelPainter::paintRemark(QPainter& painter, const VectorStyle& style) const {
  const QFont font = style.font(remarkSize);
  const QString text = picture_.still > 0 ? QStringLiteral("No motion") : QStringLiteral("No vectors in this view");
  painter.setFont(font);
  const QPointF middle = plot().center();
  const QSizeF size(textWidth(font, text) + font.pixelSize(), 1.6 * font.pixelSize());
  painter.setPen(Qt::NoPen);
  painter.setBrush(style.theme.background);
  painter.drawRect(QRectF(middle - QPointF(0.5 * size.width(), 0.5 * size.height()), size));
  painter.setPen(style.theme.text);
  painter.drawText(middle + QPointF(-0.5 * textWidth(font, text), 0.36 * font.pixelSize()), text);
}

}  // namespace mien
