#include "TextTable.h"

#include <QPainter>
#include <algorithm>

#include "TextLines.h"

namespace mien {

namespace {

constexpr double cellPadding = 0.8, rowPadding = 0.5;             // mm
constexpr double closeCellPadding = 0.4, closeRowPadding = 0.15;  // mm

double units(double millimetres) {
  return millimetres * figureUnitsPerMillimetre;
}

/// The table with every cell broken into lines for one width.
class BrokenTable {
 public:
  BrokenTable(const TextTable& table, double width)
      : table_(table),
        padding_(units(table.close ? closeCellPadding : cellPadding)),
        rowPadding_(units(table.close ? closeRowPadding : rowPadding)) {
    setWidths(width);
    std::vector<std::string> titles;
    for (const TextTable::Column& column : table.columns) titles.push_back(column.title);
    rows_.push_back(broken(titles, true));
    for (const std::vector<std::string>& row : table.rows) rows_.push_back(broken(row, false));
  }

  double height() const {
    double sum = 0.0;
    for (const std::vector<QStringList>& row : rows_) sum += rowHeight(row);
    return sum + rowPadding_;
  }

  void paint(QPainter& painter, const QRectF& place, const FigureTheme& theme) const {
    double y = place.top();
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

PlatePanel tablePanel(const std::string& heading, const TextTable& table, double width) {
  const BrokenTable measured(table, units(width));
  const auto paint = [table](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    BrokenTable(table, place.width()).paint(painter, place, theme);
  };
  return {heading, 1, measured.height() / units(width), paint};
}

}  // namespace mien
