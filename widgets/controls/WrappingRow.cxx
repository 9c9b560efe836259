#include "WrappingRow.h"

#include <QSpacerItem>
#include <QWidget>
#include <algorithm>

namespace mien {

namespace {

bool expands(const QLayoutItem& item) {
  return item.expandingDirections() & Qt::Horizontal;
}

/// What it has in any case.
int least(const QLayoutItem& item) {
  return expands(item) ? item.minimumSize().width() : item.sizeHint().width();
}

int heightOf(const QLayoutItem& item, int width) {
  return item.hasHeightForWidth() ? item.heightForWidth(std::min(width, least(item))) : item.sizeHint().height();
}

int heightOf(const std::vector<QLayoutItem*>& line, int width) {
  int height = 0;
  for (const QLayoutItem* item : line) height = std::max(height, heightOf(*item, width));
  return height;
}

}  // namespace

WrappingRow::WrappingRow(QWidget* parent) : QLayout(parent) {
  setContentsMargins(0, 0, 0, 0);
}

WrappingRow::~WrappingRow() {
  for (QLayoutItem* item : items_) delete item;
}

void WrappingRow::addSpacing(int pixels) {
  addItem(new QSpacerItem(pixels, 0, QSizePolicy::Fixed, QSizePolicy::Minimum));
}

void WrappingRow::addStretch() {
  addItem(new QSpacerItem(0, 0, QSizePolicy::Expanding, QSizePolicy::Minimum));
}

void WrappingRow::addItem(QLayoutItem* item) {
  items_ << item;
  invalidate();
}

int WrappingRow::count() const {
  return items_.size();
}

QLayoutItem* WrappingRow::itemAt(int index) const {
  return items_.value(index);
}

QLayoutItem* WrappingRow::takeAt(int index) {
  return index >= 0 && index < items_.size() ? items_.takeAt(index) : nullptr;
}

int WrappingRow::widthOf(const Line& line) const {
  int width = 0;
  for (const QLayoutItem* item : line) width += least(*item);
  return width + spacing() * std::max(0, static_cast<int>(line.size()) - 1);
}

/// Hidden widgets take no room; spacers neither at the ends of a line.
std::vector<WrappingRow::Line> WrappingRow::lines(int width) const {
  std::vector<Line> lines(1);
  for (QLayoutItem* item : items_) {
    if (item->isEmpty() && !item->spacerItem()) continue;
    Line& line = lines.back();
    line.push_back(item);
    if (item->spacerItem() || line.size() == 1 || widthOf(line) <= width) continue;
    line.pop_back();
    while (!line.empty() && line.back()->spacerItem()) line.pop_back();
    lines.push_back({item});
  }
  return lines;
}

QSize WrappingRow::sizeHint() const {
  Line all;
  for (QLayoutItem* item : items_)
    if (!item->isEmpty() || item->spacerItem()) all.push_back(item);
  const QMargins around = contentsMargins();
  const int width = widthOf(all);
  return {width + around.left() + around.right(), heightOf(all, width) + around.top() + around.bottom()};
}

QSize WrappingRow::minimumSize() const {
  QSize size;
  for (const QLayoutItem* item : items_)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  const QMargins around = contentsMargins();
  return size + QSize(around.left() + around.right(), around.top() + around.bottom());
}

void WrappingRow::setLeastHeight(int pixels) {
  if (pixels == leastHeight_) return;
  leastHeight_ = pixels;
  invalidate();
  if (parentWidget()) parentWidget()->updateGeometry();
}

int WrappingRow::heightForWidth(int width) const {
  return std::max(leastHeight_, ownHeight(width));
}

int WrappingRow::ownHeight(int width) const {
  const QMargins around = contentsMargins();
  const int room = width - around.left() - around.right();
  int height = around.top() + around.bottom() - spacing();
  for (const Line& line : lines(room)) height += heightOf(line, room) + spacing();
  return height;
}

void WrappingRow::setGeometry(const QRect& rect) {
  QLayout::setGeometry(rect);
  QRect room = rect.marginsRemoved(contentsMargins());
  for (const Line& line : lines(room.width())) {
    room.setHeight(heightOf(line, room.width()));
    place(line, room);
    room.translate(0, room.height() + spacing());
  }
}

void WrappingRow::place(const Line& line, const QRect& rect) const {
  const auto wide = std::count_if(line.begin(), line.end(), [](const auto* item) { return expands(*item); });
  const int more = wide > 0 ? std::max(0, rect.width() - widthOf(line)) / static_cast<int>(wide) : 0;
  int left = rect.left();
  for (QLayoutItem* item : line) {
    const int width = std::min(least(*item) + (expands(*item) ? more : 0), rect.width());
    const int height = heightOf(*item, rect.width());
    item->setGeometry({left, rect.top() + (rect.height() - height) / 2, width, height});
    left += width + spacing();
  }
}

}  // namespace mien
