#include "DockScroll.h"

#include <QScrollBar>

namespace mien {

namespace {

constexpr QSize most(540, 170);  // pixels that a dock may ask for

}  // namespace

DockScroll::DockScroll(QWidget* panel) {
  setWidget(panel);
  panel->setAutoFillBackground(false);
  viewport()->setAutoFillBackground(false);
}

QSize DockScroll::sizeHint() const {
  return widget()->sizeHint();
}

QSize DockScroll::minimumSizeHint() const {
  const QSize whole = widget()->minimumSizeHint();
  const int bar = whole.height() > most.height() ? verticalScrollBar()->sizeHint().width() : 0;
  return QSize(whole.width() + bar, whole.height()).boundedTo(most);
}

}  // namespace mien
