#include "VectorKeyPainter.h"

#include <QPainter>
#include <algorithm>

#include "ArrowShape.h"
#include "AxisScale.h"
#include "RealMinus.h"
#include "TextLines.h"
#include "VectorScale.h"

namespace mien {

namespace {

constexpr double keyTextSize = 7.0, keyNumberSize = 6.5;  // pt
constexpr double barHeight = 2.6, keyTickLength = 0.7;    // mm
constexpr double mostWidth = 90.0;                        // mm, of a key in a wide figure
constexpr double leastWidth = 58.0;                       // mm: in a narrower key the bar stands below the arrow
constexpr double stackGap = 2.0;                          // mm, above it there
constexpr double endRoom = 2.2;                           // mm, for the last number or the point of the bar
constexpr double gap = 4.0;                               // mm, between arrow and bar
constexpr double tickRoom = 7.0;                          // mm, of a number below the bar
constexpr char16_t glue = 0x00a0;                         // between words that stay in one line
constexpr int barSteps = 64;                              // no step of a colour can be seen

QString number(double value) {
  return QString::number(value, 'g', 4);
}

QString glued(QString text) {
  return text.replace(' ', QChar(glue));
}

}  // namespace

VectorKeyPainter::VectorKeyPainter(const VectorStyle& style, double reference, double width,
                                   std::pair<bool, bool> beyond)
    : style_(style), reference_(reference), width_(std::min(width, figureUnits(mostWidth))), beyond_(beyond) {
  using Length = MotionVectorOptions::Length;
  const QString seen = style.length == Length::InSpace ? QStringLiteral(" in space") : QString();
  const QString scale =
      style.length == Length::Equal
          ? QStringLiteral("Arrows of equal length show directions; motion below %1 mm has none")
                .arg(QString::number(style.leastShown, 'g', 2))
          : glued("1 mm of arrow =") + ' ' + glued(QStringLiteral("%1 mm of motion").arg(number(style.scale))) + seen;
  scaleLines_ = textLines(style.font(keyTextSize), scale, isStacked() ? width_ : barLeft() - figureUnits(gap));
  scaleLines_.replaceInStrings(QString(QChar(glue)), QStringLiteral(" "));
  if (style.lacksTowards)
    scaleLines_ << textLines(style.font(keyTextSize), QStringLiteral("No motion towards the viewer"), width_);
  titleLines_ = textLines(style.font(keyTextSize), title(), width_ - barLeft());
}

bool VectorKeyPainter::hasBar() const {
  return style_.color != MotionVectorOptions::Color::None && !style_.lacksTowards;
}

bool VectorKeyPainter::isStacked() const {
  return !hasBar() || width_ < figureUnits(leastWidth);
}

double VectorKeyPainter::barLeft() const {
  return isStacked() ? 0.0 : 0.44 * width_;
}

QString VectorKeyPainter::title() const {
  return style_.color == MotionVectorOptions::Color::Towards ? QStringLiteral("Motion towards the viewer (mm)")
                                                             : QStringLiteral("Motion in space (mm)");
}

double VectorKeyPainter::height() const {
  if (!hasBar()) return referenceHeight();
  const double bar = titleLines_.size() * lineHeight(style_.font(keyTextSize)) +
                     figureUnits(barHeight + keyTickLength + 0.4) + lineHeight(style_.font(keyNumberSize));
  return isStacked() ? referenceHeight() + figureUnits(stackGap) + bar : std::max(bar, referenceHeight());
}

/// Of the arrow and its scale.
double VectorKeyPainter::referenceHeight() const {
  return (scaleLines_.size() + (reference_ > 0.0 ? 1 : 0)) * lineHeight(style_.font(keyTextSize));
}

void VectorKeyPainter::paint(QPainter& painter, const QPointF& topLeft) const {
  paintReference(painter, topLeft);
  if (!hasBar()) return;
  const QFont font = style_.font(keyTextSize);
  painter.setFont(font);
  painter.setPen(style_.theme.text);
  double y = topLeft.y() + (isStacked() ? referenceHeight() + figureUnits(stackGap) : 0.0);
  for (const QString& line : titleLines_) {
    painter.drawText(QPointF(topLeft.x() + barLeft(), y + 0.95 * font.pixelSize()), line);
    y += lineHeight(font);
  }
  const double room = isStacked() ? figureUnits(endRoom) : 0.0;
  const QRectF bar(topLeft.x() + barLeft() + room, y + figureUnits(0.4),
                   width_ - barLeft() - room - figureUnits(endRoom), figureUnits(barHeight));
  paintBar(painter, bar);
  paintTicks(painter, bar);
}

void VectorKeyPainter::paintReference(QPainter& painter, const QPointF& topLeft) const {
  const QFont font = style_.font(keyTextSize);
  double y = topLeft.y();
  if (reference_ > 0.0) {
    const double length = figureUnits(reference_ / style_.scale);
    const QPointF tail(topLeft.x(), y + 0.6 * font.pixelSize());
    painter.setPen(Qt::NoPen);
    painter.setBrush(style_.theme.text);
    painter.drawPolygon(arrowShape(tail, tail + QPointF(length, 0.0)));
    painter.setFont(font);
    painter.setPen(style_.theme.text);
    painter.drawText(QPointF(topLeft.x() + length + figureUnits(1.5), y + 0.95 * font.pixelSize()),
                     number(reference_) + " mm");
    y += lineHeight(font);
  }
  painter.setFont(font);
  painter.setPen(style_.theme.text);
  for (const QString& line : scaleLines_) {
    painter.drawText(QPointF(topLeft.x(), y + 0.95 * font.pixelSize()), line);
    y += lineHeight(font);
  }
}

/// Pointed where values lie beyond the end.
QPolygonF VectorKeyPainter::barShape(const QRectF& bar) const {
  const double point = 0.8 * bar.height(), middle = bar.center().y();
  QPolygonF shape;
  shape << bar.topLeft() << bar.topRight();
  if (beyond_.second) shape << QPointF(bar.right() + point, middle);
  shape << bar.bottomRight() << bar.bottomLeft();
  if (beyond_.first) shape << QPointF(bar.left() - point, middle);
  return shape << bar.topLeft();
}

void VectorKeyPainter::paintBar(QPainter& painter, const QRectF& bar) const {
  const VectorColors colors(style_.colorMap, style_.theme, 0.0, 1.0);
  const double point = 0.8 * bar.height(), middle = bar.center().y();
  painter.setPen(Qt::NoPen);
  if (beyond_.first) {
    painter.setBrush(colors.at(0.0));
    painter.drawPolygon(QPolygonF() << bar.topLeft() << bar.bottomLeft() << QPointF(bar.left() - point, middle));
  }
  if (beyond_.second) {
    painter.setBrush(colors.at(1.0));
    painter.drawPolygon(QPolygonF() << bar.topRight() << bar.bottomRight() << QPointF(bar.right() + point, middle));
  }
  // Each step reaches to the end of the bar: no gaps between neighbours, whatever draws them.
  for (int i = 0; i < barSteps; ++i) {
    const double share = static_cast<double>(i) / barSteps;
    painter.setBrush(colors.at((i + 0.5) / barSteps));
    painter.drawRect(QRectF(bar.left() + share * bar.width(), bar.top(), (1.0 - share) * bar.width(), bar.height()));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(style_.theme.axis, figureUnitsFromPoints(style_.theme.axisWidth)));
  painter.drawPolyline(barShape(bar));
}

void VectorKeyPainter::paintTicks(QPainter& painter, const QRectF& bar) const {
  const QFont font = style_.font(keyNumberSize);
  const AxisScale scale(style_.rangeBegin, style_.rangeEnd, false);
  const int most = std::max(2, static_cast<int>(bar.width() / figureUnits(tickRoom)));
  painter.setFont(font);
  for (const double value : rangeTicks(style_.rangeBegin, style_.rangeEnd, most)) {
    const double x = bar.left() + scale.fraction(value) * bar.width();
    painter.setPen(QPen(style_.theme.axis, figureUnitsFromPoints(style_.theme.axisWidth)));
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + figureUnits(keyTickLength)));
    const QString text = withRealMinus(number(value));
    painter.setPen(style_.theme.text);
    painter.drawText(QPointF(x - 0.5 * textWidth(font, text),
                             bar.bottom() + figureUnits(keyTickLength + 0.2) + 0.95 * font.pixelSize()),
                     text);
  }
}

}  // namespace mien
