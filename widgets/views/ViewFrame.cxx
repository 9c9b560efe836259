#include "ViewFrame.h"

#include <QEvent>
#include <QGridLayout>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ElidedLabel.h"
#include "OverflowRow.h"

namespace mien {

namespace {

constexpr int gap = 6;             // pixels between groups of buttons
constexpr int edge = 1;            // pixels, of the frame's line
constexpr int leastView = 100;     // pixels high, in which a face is more than a blot
constexpr int longestTitle = 210;  // pixels that a title has before any button; a longer one ends in dots
constexpr int longestHead = 227;   // pixels of a title and the buttons that last: views side by side at 960 pixels

}  // namespace

ViewFrame::ViewFrame(const QString& title, QWidget* view, QWidget* parent)
    : QFrame(parent),
      header_(new OverflowRow(view->objectName() + "Header", this)),
      stage_(new QGridLayout),
      view_(view),
      name_(new ElidedLabel(this)) {
  setProperty("card", true);
  setObjectName(view->objectName().replace("View", "Frame"));
  name_->setProperty("heading", true);
  name_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  setTitle(title);
  header_->setMargins(10, 5, 6, 5);
  header_->setSpacing(1);
  header_->addWidget(name_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(edge, edge, edge, edge);
  column->setSpacing(0);
  column->addWidget(header_);
  stage_->setContentsMargins(0, 0, 0, 0);
  view->setMinimumHeight(leastView);
  stage_->addWidget(view, 0, 0);
  column->addLayout(stage_, 1);
}

void ViewFrame::setTitle(const QString& title) {
  name_->setText(title);
  name_->ensurePolished();    // headings are bold
  name_->setMinimumWidth(0);  // which a label adds to what it asks for
  int room = longestHead;
  for (const QToolButton* button : lasting_)
    if (!button->isHidden()) room -= button->sizeHint().width();
  name_->setMinimumWidth(std::min({longestTitle, room, name_->sizeHint().width()}));
}

/// With the font of the window that it has come into.
void ViewFrame::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  setTitle(name_->text());
}

/// As a button comes or goes.
bool ViewFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) setTitle(name_->text());
  return QFrame::eventFilter(watched, event);
}

QToolButton* ViewFrame::button(const QString& objectName, const QString& text, const QString& toolTip) {
  auto* button = new QToolButton(this);
  button->setObjectName(objectName);
  button->setText(text);
  button->setToolTip(toolTip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QToolButton* ViewFrame::addButton(const QString& objectName, const QString& text, const QString& toolTip) {
  QToolButton* added = button(objectName, text, toolTip);
  header_->addWidget(added, ++controls_);
  return added;
}

QToolButton* ViewFrame::addLastingButton(const QString& objectName, const QString& text, const QString& toolTip) {
  QToolButton* added = button(objectName, text, toolTip);
  header_->addWidget(added);
  lasting_.push_back(added);
  added->installEventFilter(this);
  return added;
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

void ViewFrame::addFoot(QWidget* widget) {
  stage_->addWidget(widget, 0, 0, Qt::AlignBottom);
  view_->setMinimumHeight(leastView + widget->sizeHint().height());
  widget->raise();
}

void ViewFrame::addControl(QWidget* control) {
  header_->addWidget(control, ++controls_);
}

void ViewFrame::addGap() {
  header_->addSpacing(gap);
}

}  // namespace mien
