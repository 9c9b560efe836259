#include "TextTable.h"

#include <QPainter>
#include <algorithm>
#include <numeric>

#include "TextLines.h"

namespace mien {

namespace {

constexpr double cellPadding = 0.8, rowPadding = 0.5;             // mm
constexpr double closeCellPadding = 0.4, closeRowPadding = 0.15;  // mm

/// The table with every cell broken into lines for one width.
class BrokenTable {
 public:
  BrokenTable(const TextTable& table, double width)
      : table_(table),
        padding_(figureUnits(table.close ? closeCellPadding : cellPadding)),
        rowPadding_(figureUnits(table.close ? closeRowPadding : rowPadding)) {
    setWidths(width);
    std::vector<std::string> titles;
    for (const TextTable::Column& column : table.columns) titles.push_back(column.title);
    rows_.push_back(broken(titles, true));
    for (const std::vector<std::string>& row : table.rows) rows_.push_back(broken(row, false));
  }

  /// Whether all words are within the width.
  bool fits(double width) const { return std::accumulate(widths_.begin(), widths_.end(), 0.0) <= width + 1e-6; }

  double height() const {
    double sum = 0.0;
    for (const std::vector<QStringList>& row : rows_) sum += rowHeight(row);
    return sum + groupsHeight() + rowPadding_;
  }

  void paint(QPainter& painter, const QRectF& place, const FigureTheme& theme) const {
    paintGroups(painter, place, theme);
    double y = place.top() + groupsHeight();
    for (size_t i = 0; i < rows_.size(); ++i) {
      paintRow(painter, place.left(), y, rows_[i], figureFont(table_.size, i == 0), theme);
      y += rowHeight(rows_[i]);
      const bool edge = i == 0 || i + 1 == rows_.size();
      painter.setPen(QPen(edge ? theme.text : theme.grid, figureUnitsFromPoints(edge ? 0.6 : 0.3)));
      painter.drawLine(QPointF(place.left(), y), QPointF(place.right(), y));
    }
  }

 private:
  std::vector<QStringList> broken(const std::vector<std::string>& cells, bool bold) const {
    std::vector<QStringList> lines;
    for (size_t c = 0; c < cells.size() && c < widths_.size(); ++c)
      lines.push_back(
          textLines(figureFont(table_.size, bold), QString::fromStdString(cells[c]), widths_[c] - 2.0 * padding_));
    return lines;
  }

  /// What no line break makes narrower.
  double leastWidth(size_t column) const {
    double width = 0.0;
    const auto measure = [&](const std::string& cell, bool bold) {
      for (const QString& word : QString::fromStdString(cell).split(' '))
        width = std::max(width, textWidth(figureFont(table_.size, bold), word));
    };
    measure(table_.columns[column].title, true);
    for (const std::vector<std::string>& row : table_.rows)
      if (column < row.size()) measure(row[column], false);
    return width + 2.0 * padding_;
  }

  /// By their shares; a column whose words need more takes it from the others.
  void setWidths(double width) {
    const size_t count = table_.columns.size();
    std::vector<bool> isFixed(count, false);
    widths_.assign(count, 0.0);
    for (size_t pass = 0; pass < count; ++pass) {
      double room = width, shares = 0.0;
      for (size_t c = 0; c < count; ++c) isFixed[c] ? room -= widths_[c] : shares += table_.columns[c].share;
      for (size_t c = 0; c < count; ++c)
        if (!isFixed[c]) widths_[c] = std::max(0.0, room) * table_.columns[c].share / shares;
      bool any = false;
      for (size_t c = 0; c < count; ++c)
        if (!isFixed[c] && leastWidth(c) > widths_[c]) {
          widths_[c] = leastWidth(c);
          isFixed[c] = any = true;
        }
      if (!any) break;
    }
  }

  double groupsHeight() const {
    return table_.groups.empty() ? 0.0 : lineHeight(figureFont(table_.size, true)) + 2.0 * rowPadding_;
  }

  /// Each title in the middle over a rule as long as its columns.
  void paintGroups(QPainter& painter, const QRectF& place, const FigureTheme& theme) const {
    const QFont font = figureFont(table_.size, true);
    painter.setFont(font);
    painter.setPen(QPen(theme.text, figureUnitsFromPoints(0.3)));
    double x = place.left();
    size_t column = 0;
    for (const TextTable::Group& group : table_.groups) {
      const double left = x + padding_;
      for (int i = 0; i < group.columns && column < widths_.size(); ++i) x += widths_[column++];
      if (group.title.empty()) continue;
      const QString title = QString::fromStdString(group.title);
      const double y = place.top() + rowPadding_ + 0.95 * font.pixelSize(), rule = place.top() + groupsHeight();
      painter.drawText(QPointF(0.5 * (left + x - padding_ - textWidth(font, title)), y), title);
      painter.drawLine(QPointF(left, rule), QPointF(x - padding_, rule));
    }
  }

  double rowHeight(const std::vector<QStringList>& row) const {
    qsizetype lines = 1;
    for (const QStringList& cell : row) lines = std::max<qsizetype>(lines, cell.size());
    return lines * lineHeight(figureFont(table_.size)) + 2.0 * rowPadding_;
  }

  void paintRow(QPainter& painter, double x, double top, const std::vector<QStringList>& row, const QFont& font,
                const FigureTheme& theme) const {
    painter.setFont(font);
    painter.setPen(theme.text);
    for (size_t c = 0; c < row.size(); x += widths_[c++]) {
      double y = top + rowPadding_ + 0.95 * font.pixelSize();
      for (const QString& line : row[c]) {
        const double inset = table_.columns[c].numbers ? widths_[c] - padding_ - textWidth(font, line) : padding_;
        painter.drawText(QPointF(x + inset, y), line);
        y += lineHeight(font);
      }
    }
  }

  TextTable table_;
  double padding_, rowPadding_;
  std::vector<double> widths_;
  std::vector<std::vector<QStringList>> rows_;
};

}  // namespace

namespace {

constexpr double leastSize = 4.0, shrinking = 0.97;  // pt

/// In smaller type where words would be cut.
BrokenTable fittingTable(TextTable table, double width) {
  BrokenTable broken(table, width);
  while (!broken.fits(width) && table.size > leastSize) {
    table.size *= shrinking;
    broken = BrokenTable(table, width);
  }
  return broken;
}

}  // namespace

PlatePanel tablePanel(const std::string& heading, const TextTable& table, double width) {
  const BrokenTable measured = fittingTable(table, figureUnits(width));
  const auto paint = [table](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    fittingTable(table, place.width()).paint(painter, place, theme);
  };
  return {heading, 1, measured.height() / figureUnits(width), paint};
}

}  // namespace mien
