#include "PanelRow.h"

#include <QPainter>
#include <algorithm>

#include "TextLines.h"

namespace mien {

namespace {

constexpr double cellGap = 1.5;          // mm, between panels
constexpr double cellHeadingSize = 6.5;  // pt
constexpr size_t leastCells = 3;         // a single face as wide as the figure would be higher than a page

double cellWidth(double width, size_t count) {
  const double cells = static_cast<double>(std::max(count, leastCells));
  return (width - cellGap * figureUnitsPerMillimetre * (cells - 1.0)) / cells;
}

/// One size for all names of a row: smaller where one of them would be cut.
double fittingSize(const std::vector<PlatePanel>& panels, double cell) {
  double widest = 0.0;
  for (const PlatePanel& panel : panels)
    widest = std::max(widest, textWidth(figureFont(cellHeadingSize), QString::fromStdString(panel.heading)));
  return widest > cell ? cellHeadingSize * cell / widest : cellHeadingSize;
}

double headingHeight(const std::vector<PlatePanel>& panels) {
  const bool any = std::any_of(panels.begin(), panels.end(), [](const PlatePanel& p) { return !p.heading.empty(); });
  return any ? lineHeight(figureFont(cellHeadingSize)) : 0.0;
}

void paintPanel(QPainter& painter, const PlatePanel& panel, const QRectF& cell, double heading, const QFont& font,
                const FigureTheme& theme) {
  painter.setFont(font);
  painter.setPen(theme.text);
  painter.drawText(QRectF(cell.left(), cell.top(), cell.width(), heading), Qt::AlignHCenter | Qt::AlignTop,
                   QString::fromStdString(panel.heading));
  const QRectF place(cell.left(), cell.top() + heading, cell.width(), cell.width() * panel.shape);
  painter.save();
  panel.paint(painter, place, theme);
  painter.restore();
}

}  // namespace

PlatePanel panelRow(const std::string& heading, const std::vector<PlatePanel>& panels, double width) {
  const double whole = width * figureUnitsPerMillimetre, cell = cellWidth(whole, panels.size());
  double height = 0.0;
  for (const PlatePanel& panel : panels) height = std::max(height, cell * panel.shape);
  const auto paint = [panels](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    const double side = cellWidth(place.width(), panels.size());
    const QFont font = figureFont(fittingSize(panels, side));
    double x = place.left();
    for (const PlatePanel& panel : panels) {
      paintPanel(painter, panel, QRectF(x, place.top(), side, place.height()), headingHeight(panels), font, theme);
      x += side + cellGap * figureUnitsPerMillimetre;
    }
  };
  return {heading, 1, (height + headingHeight(panels)) / whole, paint};
}

}  // namespace mien
