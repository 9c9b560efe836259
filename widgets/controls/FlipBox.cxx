#include "FlipBox.h"

#include <QBoxLayout>
#include <QResizeEvent>
#include <algorithm>

namespace mien {

namespace {

constexpr double wide = 1.4;  // width over height from which two charts are legible beside each other

}  // namespace

FlipBox::FlipBox(QWidget* first, QWidget* second, int firstShare, int secondShare, QWidget* parent)
    : QWidget(parent),
      layout_(new QBoxLayout(QBoxLayout::LeftToRight, this)),
      first_(first),
      firstShare_(firstShare),
      secondShare_(secondShare) {
  layout_->setContentsMargins(0, 0, 0, 0);
  layout_->setSpacing(8);
  layout_->addWidget(first, firstShare);
  layout_->addWidget(second, secondShare);
}

void FlipBox::showAllOfFirst(int leastSecond) {
  leastSecond_ = leastSecond;
}

void FlipBox::resizeEvent(QResizeEvent* event) {
  const bool beside = event->size().width() > wide * event->size().height();
  layout_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  if (leastSecond_ > 0) giveWidths(beside, event->size().width() - layout_->spacing());
  QWidget::resizeEvent(event);
}

/// Shares in pixels: no minimum, which would keep the box from getting narrower again.
void FlipBox::giveWidths(bool beside, int room) {
  const int share = firstShare_ * room / (firstShare_ + secondShare_);
  const int first = std::max(share, std::min(first_->sizeHint().width(), room - leastSecond_));
  layout_->setStretch(0, beside ? first : firstShare_);
  layout_->setStretch(1, beside ? room - first : secondShare_);
}

}  // namespace mien
