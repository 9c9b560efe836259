#include "ViewFrame.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

namespace mien {

namespace {

constexpr int gap = 10;  // pixels between groups of buttons

}  // namespace

ViewFrame::ViewFrame(const QString& title, QWidget* view, QWidget* parent) : QFrame(parent), header_(new QHBoxLayout) {
  setObjectName("card");
  auto* name = new QLabel(title, this);
  name->setProperty("heading", true);
  header_->setContentsMargins(10, 5, 6, 5);
  header_->setSpacing(1);
  header_->addWidget(name);
  header_->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 1);
  column->setSpacing(0);
  column->addLayout(header_);
  column->addWidget(view, 1);
}

QToolButton* ViewFrame::addButton(const QString& objectName, const QString& text, const QString& toolTip) {
  auto* button = new QToolButton(this);
  button->setObjectName(objectName);
  button->setText(text);
  button->setToolTip(toolTip);
  button->setFocusPolicy(Qt::TabFocus);
  header_->addWidget(button);
  return button;
}

QToolButton* ViewFrame::addToggle(const QString& objectName, const QString& text, const QString& toolTip, bool on) {
  QToolButton* button = addButton(objectName, text, toolTip);
  button->setCheckable(true);
  button->setChecked(on);
  return button;
}

void ViewFrame::addBelow(QWidget* widget) {
  layout()->addWidget(widget);
}

void ViewFrame::addControl(QWidget* control) {
  header_->addWidget(control);
}

void ViewFrame::addGap() {
  header_->addSpacing(gap);
}

}  // namespace mien
