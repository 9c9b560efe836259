#include "ThumbnailStrip.h"

#include <QHBoxLayout>
#include <QPixmap>
#include <QToolButton>
#include <algorithm>

namespace mien {

ThumbnailStrip::ThumbnailStrip(QWidget* parent) : QWidget(parent) {
  setObjectName("smoothingThumbnails");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  for (int i = 0; i < count; ++i) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString("smoothingThumbnail%1").arg(i));
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({side * 3 / 4, side});
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(tr("The face with a value of the smoothing parameter a; click to use it"));
    button->setEnabled(false);
    connect(button, &QToolButton::clicked, this, [this, i] { emit chosen(pictures_[i].a); });
    row->addWidget(button);
    buttons_.push_back(button);
  }
}

void ThumbnailStrip::setPictures(const std::vector<Picture>& pictures) {
  pictures_ = pictures;
  for (size_t i = 0; i < buttons_.size(); ++i) {
    const bool there = i < pictures.size(), good = there && !pictures[i].image.isNull();
    if (!there) continue;
    const QString a = QString::number(pictures[i].a, 'g', 3);
    buttons_[i]->setEnabled(good);
    buttons_[i]->setIcon(good ? QIcon(QPixmap::fromImage(pictures[i].image)) : QIcon());
    buttons_[i]->setText(good ? tr("a = %1").arg(a) : tr("a = %1: none").arg(a));
    buttons_[i]->setToolTip(good ? tr("The face with a = %1; click to use it").arg(a) : pictures[i].reason);
  }
  showSome();
}

QSize ThumbnailStrip::sizeHint() const {
  const QSize one = buttons_.front()->sizeHint();
  return {count * one.width() + (count - 1) * layout()->spacing(), one.height()};
}

QSize ThumbnailStrip::minimumSizeHint() const {
  const QSize one = buttons_.front()->sizeHint();
  return {2 * one.width() + layout()->spacing(), one.height()};
}

void ThumbnailStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showSome();
}

/// As many as there is room for, spread from the first to the last.
void ThumbnailStrip::showSome() {
  const int there = pictures_.empty() ? count : static_cast<int>(pictures_.size());
  int widest = 1;
  for (const QToolButton* button : buttons_) widest = std::max(widest, button->sizeHint().width());
  const int room = (width() + layout()->spacing()) / (widest + layout()->spacing());
  const int shown = std::clamp(room, std::min(2, there), there);
  std::vector<bool> isShown(buttons_.size());
  for (int i = 0; i < shown; ++i) isShown[shown > 1 ? i * (there - 1) / (shown - 1) : 0] = true;
  for (size_t i = 0; i < buttons_.size(); ++i) buttons_[i]->setVisible(isShown[i]);
}

}  // namespace mien
