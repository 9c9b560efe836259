#include "OverflowRow.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

namespace mien {

namespace {

constexpr int panelMargin = 10, panelSpacing = 6;  // pixels

bool growsSideways(const QWidget& widget) {
  return widget.sizePolicy().expandingDirections() & Qt::Horizontal;
}

/// What it has in any case.
int leastWidth(const QWidget& widget) {
  if (!growsSideways(widget))
    return std::clamp(widget.sizeHint().width(), widget.minimumWidth(), widget.maximumWidth());
  return widget.minimumWidth() > 0 ? widget.minimumWidth() : widget.minimumSizeHint().width();
}

/// By its owner, and not only because nothing of the window is shown yet.
bool isPutAway(const QWidget& widget) {
  return widget.isHidden() && widget.testAttribute(Qt::WA_WState_ExplicitShowHide);
}

/// Those that Tab reaches: the widget itself, or what is in it.
QList<QWidget*> reached(QWidget* widget) {
  if (widget->focusPolicy() & Qt::TabFocus) return {widget};
  QList<QWidget*> inside;
  for (auto* child : widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) inside << reached(child);
  return inside;
}

}  // namespace

OverflowRow::OverflowRow(const QString& name, QWidget* parent)
    : QWidget(parent),
      row_(new QHBoxLayout(this)),
      more_(new QToolButton(this)),
      panel_(new QFrame(this, Qt::Popup)),
      column_(new QVBoxLayout(panel_)) {
  setObjectName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->addWidget(more_);
  more_->setObjectName(name + "More");
  more_->setText(QStringLiteral("\u22ef"));
  more_->setAccessibleName(tr("More"));
  more_->setToolTip(tr("What there is no room for"));
  more_->setFocusPolicy(Qt::TabFocus);
  more_->hide();
  panel_->setProperty("card", true);
  column_->setContentsMargins(panelMargin, panelMargin, panelMargin, panelMargin);
  column_->setSpacing(panelSpacing);
  connect(more_, &QToolButton::clicked, this, &OverflowRow::openPanel);
}

void OverflowRow::addWidget(QWidget* widget, int rank) {
  items_.push_back({widget, rank, 0});
  row_->insertWidget(row_->count() - 1, widget, growsSideways(*widget) ? 1 : 0);
  widget->installEventFilter(this);
}

void OverflowRow::addLabelled(const QString& label, QWidget* widget, int rank) {
  auto* both = new QWidget(this);
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  both->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  auto* name = new QLabel(label, both);
  name->setBuddy(widget);
  name->setToolTip(widget->toolTip());
  row->addWidget(name);
  row->addWidget(widget);
  addWidget(both, rank);
}

void OverflowRow::addSpacing(int pixels) {
  items_.push_back({nullptr, 0, pixels});
  row_->insertSpacing(row_->count() - 1, pixels);
}

void OverflowRow::addStretch() {
  items_.push_back({nullptr, 0, 0});
  row_->insertStretch(row_->count() - 1);
}

void OverflowRow::setMargins(int left, int top, int right, int bottom) {
  row_->setContentsMargins(left, top, right, bottom);
}

void OverflowRow::setSpacing(int pixels) {
  row_->setSpacing(pixels);
}

bool OverflowRow::takesRoom(const Item& item) const {
  return !item.widget || !isPutAway(*item.widget) || item.widget->sizePolicy().retainSizeWhenHidden();
}

int OverflowRow::widthOf(const std::vector<bool>& leaves) const {
  const QMargins around = row_->contentsMargins();
  int width = around.left() + around.right() - row_->spacing();
  bool some = false;
  for (size_t i = 0; i < items_.size(); ++i) {
    some = some || leaves[i];
    if (leaves[i] || !takesRoom(items_[i])) continue;
    width += items_[i].widget ? leastWidth(*items_[i].widget) + row_->spacing() : items_[i].pixels;
  }
  return some ? width + more_->sizeHint().width() + row_->spacing() : width;
}

/// One after the other, until the rest has room.
std::vector<bool> OverflowRow::leaving() const {
  std::vector<bool> leaves(items_.size());
  while (widthOf(leaves) > width()) {
    int next = -1;
    for (size_t i = 0; i < items_.size(); ++i) {
      if (leaves[i] || items_[i].rank == 0 || !takesRoom(items_[i])) continue;
      if (next < 0 || items_[i].rank >= items_[next].rank) next = static_cast<int>(i);
    }
    if (next < 0) break;
    leaves[next] = true;
  }
  return leaves;
}

/// Whether its owner has hidden it stays so.
void OverflowRow::move(QWidget* widget, bool toPanel) {
  const bool putAway = isPutAway(*widget);
  if (toPanel) {
    column_->addWidget(widget, 0, Qt::AlignLeft);
  } else {
    int place = 0;
    for (const Item& item : items_) {
      if (item.widget == widget) break;
      place += !item.widget || !isInPanel(item.widget);
    }
    row_->insertWidget(place, widget, growsSideways(*widget) ? 1 : 0);
  }
  if (!putAway) widget->show();
}

void OverflowRow::arrange() {
  if (arranging_) return;
  arranging_ = true;
  const std::vector<bool> leaves = leaving();
  bool changed = false;
  for (size_t i = 0; i < items_.size(); ++i) {
    QWidget* widget = items_[i].widget;
    if (!widget || isInPanel(widget) == leaves[i]) continue;
    move(widget, leaves[i]);
    changed = true;
  }
  more_->setVisible(std::find(leaves.begin(), leaves.end(), true) != leaves.end());
  if (changed) orderFocus();
  row_->activate();
  arranging_ = false;
}

/// What comes back from the panel comes at the end of the order in which Tab goes.
void OverflowRow::orderFocus() {
  QList<QWidget*> inRow;
  QWidget* stays = nullptr;
  for (const Item& item : items_) {
    if (!item.widget || isInPanel(item.widget)) continue;
    const QList<QWidget*> inputs = reached(item.widget);
    if (!stays && item.rank == 0 && !inputs.isEmpty()) stays = inputs.front();
    inRow << inputs;
  }
  inRow << more_;
  QWidget* before = stays ? stays->previousInFocusChain() : nullptr;
  while (before && before != stays && (inRow.contains(before) || !(before->focusPolicy() & Qt::TabFocus)))
    before = before->previousInFocusChain();
  if (before && before != stays && before->window() == window()) setTabOrder(before, inRow.front());
  for (int i = 1; i < inRow.size(); ++i) setTabOrder(inRow[i - 1], inRow[i]);
}

void OverflowRow::openPanel() {
  panel_->adjustSize();
  const QPoint right = more_->mapToGlobal(QPoint(more_->width(), more_->height() + 2));
  panel_->move(std::max(0, right.x() - panel_->width()), right.y());
  panel_->show();
  for (const Item& item : items_)
    if (item.widget && isInPanel(item.widget) && item.widget->isEnabled())
      for (QWidget* input : reached(item.widget)) return input->setFocus(Qt::PopupFocusReason);
}

QSize OverflowRow::sizeHint() const {
  int height = 0;
  for (const Item& item : items_)
    if (item.widget && takesRoom(item)) height = std::max(height, item.widget->sizeHint().height());
  const QMargins around = row_->contentsMargins();
  return {widthOf(std::vector<bool>(items_.size())), height + around.top() + around.bottom()};
}

QSize OverflowRow::minimumSizeHint() const {
  std::vector<bool> leaves(items_.size());
  for (size_t i = 0; i < items_.size(); ++i) leaves[i] = items_[i].rank > 0;
  return {widthOf(leaves), sizeHint().height()};
}

void OverflowRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool OverflowRow::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest) arrange();
  return done;
}

/// What its owner shows or hides while it is in the panel takes room in the row all the same.
bool OverflowRow::eventFilter(QObject* watched, QEvent* event) {
  const bool changes = event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent;
  if (changes && !arranging_) arrange();
  return QWidget::eventFilter(watched, event);
}

}  // namespace mien
