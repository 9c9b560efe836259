#include "VectorView.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVariant>
#include <algorithm>

#include "MotionVectorFigure.h"
#include "OwnKeys.h"
#include "ScreenFigure.h"
#include "Theme.h"

namespace mien {

VectorView::VectorView(const QString& objectName, QWidget* parent) : QWidget(parent) {
  setObjectName(objectName);
  setProperty(ownKeys, QStringList{tr("Esc: the whole face again")});
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::CrossCursor);
}

VectorView::~VectorView() = default;

void VectorView::setFigure(std::shared_ptr<const MotionVectorFigure> figure) {
  figure_ = std::move(figure);
  picture_ = QPixmap();
  update();
}

void VectorView::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

QPointF VectorView::shift() const {
  return {std::max(0.0, 0.5 * (width() - figure_->size().width() / figureUnitsPerPixel)), 0.0};
}

QPointF VectorView::pixelOf(const Eigen::Vector2d& place) const {
  return figure_ ? figure_->panels().front().toFigure(place) / figureUnitsPerPixel + shift() : QPointF();
}

Eigen::Vector2d VectorView::placeOf(const QPointF& pixel) const {
  return figure_->panels().front().toFace((pixel - shift()) * figureUnitsPerPixel);
}

void VectorView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::current().panel);
  if (!figure_) {
    painter.setPen(Theme::current().faintText);
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  if (picture_.isNull()) drawPicture();
  painter.drawPixmap(0, 0, picture_);
  if (!start_ || band_.isNull()) return;
  QColor color = Theme::current().accent;
  painter.setPen(color);
  color.setAlpha(40);
  painter.setBrush(color);
  painter.drawRect(band_);
}

/// Kept, because arrows are slow to draw and a rectangle that is dragged is not.
void VectorView::drawPicture() {
  picture_ = QPixmap(size() * devicePixelRatioF());
  picture_.setDevicePixelRatio(devicePixelRatioF());
  picture_.fill(Theme::current().panel);
  QPainter painter(&picture_);
  painter.translate(shift());
  painter.scale(1.0 / figureUnitsPerPixel, 1.0 / figureUnitsPerPixel);
  figure_->paint(painter);
}

void VectorView::resizeEvent(QResizeEvent*) {
  picture_ = QPixmap();
  emit resized();
}

void VectorView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !figure_) return;
  start_ = event->pos();
  band_ = QRect();
}

void VectorView::mouseMoveEvent(QMouseEvent* event) {
  if (!start_ || !(event->buttons() & Qt::LeftButton)) return;
  band_ = QRect(*start_, event->pos()).normalized();
  update();
}

/// A hand that trembles in a click is no rectangle.
void VectorView::mouseReleaseEvent(QMouseEvent*) {
  const int least = QApplication::startDragDistance();
  if (start_ && figure_ && band_.width() > least && band_.height() > least) {
    Eigen::AlignedBox2d region(placeOf(band_.topLeft()));
    region.extend(placeOf(band_.bottomRight()));
    emit dragged(region);
  }
  start_.reset();
  update();
}

void VectorView::mouseDoubleClickEvent(QMouseEvent*) {
  start_.reset();
  emit wholeAsked();
}

void VectorView::keyPressEvent(QKeyEvent* event) {
  event->key() == Qt::Key_Escape ? emit wholeAsked() : QWidget::keyPressEvent(event);
}

}  // namespace mien
