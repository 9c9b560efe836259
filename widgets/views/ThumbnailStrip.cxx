#include "ThumbnailStrip.h"

#include <QHBoxLayout>
#include <QPixmap>
#include <QToolButton>

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
    buttons_[i]->setVisible(there);
    if (!there) continue;
    const QString a = QString::number(pictures[i].a, 'g', 3);
    buttons_[i]->setEnabled(good);
    buttons_[i]->setIcon(good ? QIcon(QPixmap::fromImage(pictures[i].image)) : QIcon());
    buttons_[i]->setText(good ? tr("a = %1").arg(a) : tr("a = %1: none").arg(a));
    buttons_[i]->setToolTip(good ? tr("The face with a = %1; click to use it").arg(a) : pictures[i].reason);
  }
}

}  // namespace mien
