#include "RangeDelegate.h"

#include <QPainter>
#include <QStyle>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "Theme.h"

namespace mien {

namespace {

constexpr double shownDeviations = 3.0;  // on either side of the mean
constexpr double margin = 4.0, rangeHeight = 2.0, tickWidth = 2.0, tickHeight = 4.0, foot = 1.0;  // pixels

}  // namespace

/// The text is drawn here: the style's own margins would cut every second number.
void RangeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem blank = option;
  initStyleOption(&blank, index);
  const QString text = blank.text;
  blank.text.clear();
  blank.widget->style()->drawControl(QStyle::CE_ItemViewItem, &blank, painter, blank.widget);
  const Theme& theme = Theme::current();
  const QRectF cell(option.rect);
  painter->setFont(blank.font);
  const bool outside = index.data(outsideRole).toBool();
  const QColor ink = option.state & QStyle::State_Selected ? theme.accentText : outside ? theme.error : theme.text;
  painter->setPen(ink);
  const QVariant place = index.data(placeRole);
  painter->drawText(cell.adjusted(0, 0, 0, place.isValid() ? -tickHeight - foot : 0), Qt::AlignCenter, text);
  if (!place.isValid()) return;
  const double half = 0.5 * cell.width() - margin, middle = cell.center().x(),
               y = cell.bottom() - foot - 0.5 * tickHeight;
  const double share = std::clamp(place.toDouble() / shownDeviations, -1.0, 1.0);
  const double range = half / shownDeviations;
  painter->fillRect(QRectF(middle - half, y - 0.5, 2 * half, 1.0), theme.line);
  painter->fillRect(QRectF(middle - range, y - 0.5 * rangeHeight, 2 * range, rangeHeight), theme.faintText);
  painter->fillRect(QRectF(middle + share * half - 0.5 * tickWidth, y - 0.5 * tickHeight, tickWidth, tickHeight), ink);
}

}  // namespace mien
