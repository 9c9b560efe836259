#include "ValueSlider.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

namespace mien {

namespace {

constexpr double handle = 7.0;  // radius in pixels
constexpr double groove = 4.0;  // height in pixels

}  // namespace

ValueSlider::ValueSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setFocusPolicy(Qt::StrongFocus);
}

void ValueSlider::setShownValue(double value) {
  if (value == shown_) return;
  shown_ = value;
  update();
}

void ValueSlider::setRangeMarks(std::optional<QPair<int, int>> range) {
  range_ = range;
  update();
}

double ValueSlider::position(double value) const {
  const double share = (qBound<double>(minimum(), value, maximum()) - minimum()) / (maximum() - minimum());
  return handle + 1 + share * (width() - 2 * (handle + 1));
}

int ValueSlider::valueAt(double x) const {
  const double share = (x - handle - 1) / (width() - 2 * (handle + 1));
  const int value = static_cast<int>(std::lround(minimum() + share * (maximum() - minimum())));
  return qBound(minimum(), value, maximum());
}

void ValueSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double middle = height() / 2.0, zero = position(0), at = position(value());
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Mid));
  painter.drawRoundedRect(QRectF(1, middle - groove / 2, width() - 2, groove), groove / 2, groove / 2);
  if (minimum() < 0) painter.drawRect(QRectF(zero - 0.75, middle - handle, 1.5, 2 * handle));
  if (range_) paintRange(painter);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(isEnabled() ? QPalette::Highlight : QPalette::Mid));
  const double from = minimum() < 0 || value() == minimum() ? zero : 1.0;  // of one that begins with 0 the groove's end
  painter.drawRect(QRectF(qMin(from, at), middle - groove / 2, std::abs(at - from), groove));
  if (std::lround(shown_) != value()) {
    const double x = position(shown_), y = middle + 3;
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawPolygon(QPolygonF({{x, y}, {x - 4, y + 6.5}, {x + 4, y + 6.5}}));
  }
  painter.setBrush(palette().color(QPalette::Base));
  painter.setPen(QPen(palette().color(!isEnabled()                   ? QPalette::Mid
                                      : hasFocus() || isSliderDown() ? QPalette::Highlight
                                                                     : QPalette::PlaceholderText),
                      hasFocus() ? 2.2 : 1.4));
  painter.drawEllipse(QPointF(at, middle), handle - 1, handle - 1);
}

void ValueSlider::paintRange(QPainter& painter) const {
  const double left = position(range_->first), right = position(range_->second), middle = height() / 2.0, serif = 3.0;
  QColor color = palette().color(QPalette::Highlight);
  painter.setPen(QPen(color, 1.6));
  painter.setBrush(Qt::NoBrush);
  const double top = middle - handle - 1, bottom = middle + handle + 1;
  painter.drawPolyline(QPolygonF({{left + serif, top}, {left, top}, {left, bottom}, {left + serif, bottom}}));
  painter.drawPolyline(QPolygonF({{right - serif, top}, {right, top}, {right, bottom}, {right - serif, bottom}}));
  color.setAlpha(60);
  painter.fillRect(QRectF(left, middle - groove, right - left, 2 * groove), color);
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  setSliderDown(true);
  mouseMoveEvent(event);
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) setValue(valueAt(event->pos().x()));
}

void ValueSlider::mouseReleaseEvent(QMouseEvent*) {
  setSliderDown(false);
}

void ValueSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  doubleClickResets_ ? setValue(0) : mousePressEvent(event);
}

/// Only with focus, so that scrolling a panel does not move the face.
void ValueSlider::wheelEvent(QWheelEvent* event) {
  hasFocus() ? QSlider::wheelEvent(event) : event->ignore();
}

}  // namespace mien
