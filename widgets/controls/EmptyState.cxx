#include "EmptyState.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "FramedButton.h"

namespace mien {

namespace {

constexpr int longestText = 560, betweenButtons = 6, aboveButtons = 6;  // pixels

QLabel* centred(QWidget* parent, const QString& text, const char* look) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignCenter);
  label->setProperty(look, true);
  return label;
}

}  // namespace

EmptyState::EmptyState(const QString& name, const QString& title, const QString& text, QWidget* parent)
    : QWidget(parent), text_(centred(this, text, "faint")), buttons_(new QHBoxLayout) {
  setObjectName(name);
  text_->setMaximumWidth(longestText);
  buttons_->setSpacing(betweenButtons);
  buttons_->addStretch();
  buttons_->addStretch();
  auto* middle = new QHBoxLayout;
  middle->addStretch();
  middle->addWidget(text_, 1000);
  middle->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addStretch();
  column->addWidget(centred(this, title, "heading"));
  column->addLayout(middle);
  column->addSpacing(aboveButtons);
  column->addLayout(buttons_);
  column->addStretch();
}

void EmptyState::setText(const QString& text) {
  text_->setText(text);
}

QToolButton* EmptyState::addButton(const QString& name, const QString& text, const QString& toolTip) {
  auto* button = new QToolButton(this);
  makeFramed(button, name, text, toolTip);
  buttons_->insertWidget(buttons_->count() - 1, button);
  return button;
}

}  // namespace mien
