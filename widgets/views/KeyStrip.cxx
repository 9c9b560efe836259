#include "KeyStrip.h"

#include <QPainter>
#include <QVBoxLayout>

#include "Theme.h"

namespace mien {

KeyStrip::KeyStrip(QWidget* key, QWidget* parent) : QWidget(parent) {
  QSizePolicy policy = key->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  key->setSizePolicy(policy);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(key);
}

/// As the view ends above it.
void KeyStrip::paintEvent(QPaintEvent*) {
  QPainter(this).fillRect(rect(), Theme::current().viewBottom);
}

}  // namespace mien
