#include "PictureLabel.h"

#include <QPainter>

#include "Theme.h"

namespace mien {

PictureLabel::PictureLabel(QWidget* parent) : QLabel(parent) {
  setMinimumSize(100, 60);
}

void PictureLabel::setPicture(const QImage& picture) {
  picture_ = picture;
  update();
}

void PictureLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::current().viewBottom);
  if (picture_.isNull()) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QRectF place(QPointF(), QSizeF(picture_.size()).scaled(size(), Qt::KeepAspectRatio));
  place.moveCenter(QRectF(rect()).center());
  painter.drawImage(place, picture_);
}

}  // namespace mien
