#include "ColorScale.h"

#include <QLinearGradient>
#include <QPainter>
#include <algorithm>

#include "CurveView.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int side = 12, scaleGap = 16, barHeight = 9, above = 5, tick = 3, below = 3;  // pixels
constexpr int shortestBar = 40, narrowBelow = 330, betweenNumbers = 6;
constexpr double point = 8.0;  // pixels, length of the pointed end

QString mostText(double millimetres) {
  return ColorScale::tr("max %1 mm").arg(millimetres, 0, 'f', 1);
}

QString numberText(double millimetres) {
  return QString::number(millimetres, 'g', 3);
}

}  // namespace

ColorScale::ColorScale(CurveView* view, QWidget* parent) : QWidget(parent), view_(view) {
  setObjectName("curveScale");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(
      tr("Displacement: how far the curves have moved from the neutral face, in mm, without the turns of the head or "
         "with them. A pointed end: something has moved further than the last colour"));
  connect(view_, &CurveView::movementChanged, this, QOverload<>::of(&QWidget::update));
}

bool ColorScale::isExceeded() const {
  return view_->most() > view_->rangeEnd();
}

QSize ColorScale::sizeHint() const {
  return {300, above + barHeight + tick + below + fontMetrics().height()};
}

QSize ColorScale::minimumSizeHint() const {
  return {side + titleWidth(true) + scaleGap + shortestBar + roomAfter(), sizeHint().height()};
}

bool ColorScale::isNarrow() const {
  return width() < narrowBelow;
}

QString ColorScale::title() const {
  const bool withHead = view_->isWithHead();
  if (isNarrow()) return withHead ? tr("Moved, with head") : tr("Moved, without head");
  return withHead ? tr("Displacement, with head") : tr("Displacement, without head");
}

/// The same for all texts, so that the bar stays.
int ColorScale::titleWidth(bool narrow) const {
  const QFontMetrics metrics = fontMetrics();
  const QString longest = narrow ? tr("Moved, without head") : tr("Displacement, without head");
  return std::max(metrics.horizontalAdvance(longest), metrics.horizontalAdvance(mostText(88.8)));
}

void ColorScale::paintBar(QPainter& painter, const QRectF& bar) const {
  const Theme& theme = Theme::current();
  QLinearGradient colors(bar.topLeft(), bar.topRight());
  colors.setColorAt(0.0, theme.curve);
  colors.setColorAt(1.0, theme.curveMoved);
  QPolygonF shape;
  shape << bar.topLeft() << bar.topRight();
  if (isExceeded()) shape << QPointF(bar.right() + point, bar.center().y());
  shape << bar.bottomRight() << bar.bottomLeft();
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(colors);
  painter.drawPolygon(shape);
}

void ColorScale::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::current();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetrics metrics = fontMetrics();
  const int before = side + titleWidth(isNarrow()) + scaleGap;
  const QRectF bar(before, above, std::max(20, width() - before - roomAfter()), barHeight);
  paintBar(painter, bar);
  const double low = bar.bottom() + tick + metrics.ascent();
  painter.setPen(theme.text);
  painter.drawText(QPointF(side, low - metrics.height()), title());
  painter.setPen(isExceeded() ? theme.curveMoved : theme.text);
  painter.drawText(QPointF(side, low), mostText(view_->most()));
  painter.setPen(theme.text);
  paintNumbers(painter, bar, low);
}

/// Behind the bar, for half of its last number, the unit and the pointed end.
int ColorScale::roomAfter() const {
  const QFontMetrics metrics = fontMetrics();
  const int half = metrics.horizontalAdvance(numberText(view_->rangeEnd())) / 2;
  return std::max(half + metrics.horizontalAdvance(tr(" mm")), static_cast<int>(point)) + side / 2;
}

/// The ends first; the middle where it is clear of them.
std::vector<QRectF> ColorScale::numberPlaces(const QRectF& bar) const {
  const QFontMetrics metrics = fontMetrics();
  std::vector<QRectF> places;
  for (double share : {0.0, 1.0, 0.5}) {
    const QString number = numberText(share * view_->rangeEnd());
    const double wide = metrics.horizontalAdvance(number);
    const double whole = share == 1.0 ? metrics.horizontalAdvance(number + tr(" mm")) : wide;
    const QRectF place(bar.left() + share * bar.width() - 0.5 * wide, bar.bottom() + tick, whole, metrics.height());
    const QRectF clear = place.adjusted(-betweenNumbers, 0, betweenNumbers, 0);
    const auto meets = [&](const QRectF& other) { return other.intersects(clear); };
    if (share == 0.5 && std::any_of(places.begin(), places.end(), meets)) break;
    places.push_back(place);
  }
  return places;
}

void ColorScale::paintNumbers(QPainter& painter, const QRectF& bar, double low) const {
  const double shares[] = {0.0, 1.0, 0.5};
  const std::vector<QRectF> places = numberPlaces(bar);
  for (size_t i = 0; i < places.size(); ++i) {
    const double x = bar.left() + shares[i] * bar.width();
    const QString number = numberText(shares[i] * view_->rangeEnd());
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + tick));
    painter.drawText(QPointF(places[i].left(), low), shares[i] == 1.0 ? number + tr(" mm") : number);
  }
}

}  // namespace mien
