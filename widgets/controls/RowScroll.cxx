#include "RowScroll.h"

#include <QEvent>
#include <QLayout>

namespace mien {

namespace {

constexpr int mostLost = 60;  // pixels: rows that are higher than that are cut

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
  setWidgetResizable(true);
  setFocusPolicy(Qt::NoFocus);
}

void RowScroll::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

/// What it scrolls has another layout now.
bool RowScroll::eventFilter(QObject* watched, QEvent* event) {
  const bool done = QScrollArea::eventFilter(watched, event);
  if (watched == widget() && (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)) fit();
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

void RowScroll::fit() {
  if (fitting_ || !widget()) return;
  fitting_ = true;
  const int room = contentsRect().height();
  const bool scrolls = widget()->minimumSizeHint().height() > room;
  const QMargins margins(0, 0, 0, scrolls ? room - endOfRows(room) : 0);
  if (margins != viewportMargins()) setViewportMargins(margins);
  fitting_ = false;
}

}  // namespace mien
