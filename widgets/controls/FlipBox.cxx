#include "FlipBox.h"

#include <QBoxLayout>
#include <QResizeEvent>

namespace mien {

namespace {

constexpr double wide = 1.4;  // width over height from which two charts are legible beside each other

}  // namespace

FlipBox::FlipBox(QWidget* first, QWidget* second, int firstShare, int secondShare, QWidget* parent)
    : QWidget(parent), layout_(new QBoxLayout(QBoxLayout::LeftToRight, this)) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(8);
  layout_->addWidget(first, firstShare);
  layout_->addWidget(second, secondShare);
}

void FlipBox::resizeEvent(QResizeEvent* event) {
  const bool beside = event->size().width() > wide * event->size().height();
  layout_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

}  // namespace mien
