#include "RowScroll.h"

#include <QBoxLayout>
#include <QEvent>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <algorithm>

namespace mien {

namespace {

constexpr int mostLost = 60;     // pixels: rows that are higher than that are cut
constexpr int mostBetween = 16;  // pixels, between rows that are spread

/// Rows, and not what only holds them.
void collectRows(const QWidget* widget, const QWidget* page, QList<QRect>& rows) {
  for (const auto* child : widget->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!child->isVisibleTo(page) || child->isWindow()) continue;
    const QRect place(child->mapTo(const_cast<QWidget*>(page), QPoint()), child->size());
    const bool holds = child->layout() && child->height() > mostLost;
    holds ? collectRows(child, page, rows) : rows.append(place);
  }
}

}  // namespace

RowScroll::RowScroll(QWidget* parent) : QScrollArea(parent) {
  setFrameShape(QFrame::NoFrame);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
}

void RowScroll::spread(QBoxLayout* rows) {
  spread_ = rows;
  usualSpacing_ = rows->spacing();
}

void RowScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

void RowScroll::showEvent(QShowEvent* event) {
  QScrollArea::showEvent(event);
  fit();
}

/// What it scrolls asks for another layout; it has got its size when QScrollArea is done.
bool RowScroll::event(QEvent* event) {
  const bool done = QScrollArea::event(event);
  if (event->type() == QEvent::LayoutRequest) fit();
  return done;
}

/// The last place up to `room` that goes through no row; `room` where there is none near it.
int RowScroll::endOfRows(int room) const {
  QList<QRect> rows;
  collectRows(widget(), widget(), rows);
  for (int end = room; end > room - mostLost && end > 0; --end) {
    bool isBetween = true;
    for (const QRect& row : qAsConst(rows)) isBetween = isBetween && (row.top() >= end || row.bottom() < end);
    if (isBetween) return end;
  }
  return room;
}

/// Pixels for the rows, from top to bottom.
int RowScroll::room() const {
  const bool isWide = horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff &&
                      widget()->minimumSizeHint().width() > viewport()->width();
  return contentsRect().height() - (isWide ? horizontalScrollBar()->sizeHint().height() : 0);
}

/// What they need beside no bar.
int RowScroll::need() const {
  const QLayout* layout = widget()->layout();
  const QSize least = widget()->minimumSizeHint();
  const bool flows = layout && layout->hasHeightForWidth();
  const int width = std::max(contentsRect().width(), least.width());
  return flows ? std::max(least.height(), widget()->heightForWidth(width)) : least.height();
}

void RowScroll::spreadRows(int room) {
  const int count = spread_->count(), row = count ? spread_->itemAt(0)->sizeHint().height() : 0;
  if (row <= 0) return;
  const QMargins margins = widget()->layout()->contentsMargins();
  const int inside = room - margins.top(), all = count * (row + usualSpacing_) - usualSpacing_ + margins.bottom();
  const int shown = std::max(1, inside / row), spare = inside - shown * row;
  const int spacing = all <= inside ? usualSpacing_ : std::min(spare / shown, mostBetween);
  if (spacing != spread_->spacing()) spread_->setSpacing(spacing);  // asks for another layout, which comes back here
}

/// Qt's own way of showing a bar as needed measures before the margin below is set, and may then leave the bar over
/// rows that all fit.
void RowScroll::fitBar() {
  if (spread_) spreadRows(room());
  if (QLayout* layout = widget()->layout()) layout->activate();
  const Qt::ScrollBarPolicy policy = need() > room() ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff;
  if (policy == verticalScrollBarPolicy()) return;
  setVerticalScrollBarPolicy(policy);
  setViewportMargins({});  // which lays the rows out again, also while this is hidden
}

void RowScroll::fit() {
  if (fitting_ || !widget()) return;
  const QScopedValueRollback<bool> guard(fitting_, true);
  fitBar();
  const bool scrolls = verticalScrollBarPolicy() == Qt::ScrollBarAlwaysOn;
  const QMargins margins(0, 0, 0, scrolls ? room() - endOfRows(room()) : 0);
  if (margins != viewportMargins()) setViewportMargins(margins);
  QLayout* layout = widget()->layout();  // of a page that was hidden it may still be as wide as without a bar
  if (layout && layout->geometry() != widget()->contentsRect()) layout->setGeometry(widget()->contentsRect());
}

}  // namespace mien
