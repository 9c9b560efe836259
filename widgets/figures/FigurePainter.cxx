#include "FigurePainter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "PanelLabel.h"

namespace mien {

namespace {

constexpr double leastPanel = 38.0;   // mm: narrower panels have no room for three numbers on their x axis
constexpr double leastHeight = 24.0;  // mm, of a plot
constexpr double plotShape = 0.55;    // height over width of a panel's plot ...
constexpr double mostHeight = 65.0;   // mm: ... until that is taller than a figure on a page should be
constexpr double columnGap = 3.0;     // mm
constexpr double rowGap = 3.0;        // mm

}  // namespace

FigurePainter::FigurePainter(const Figure& figure, const FigureTheme& theme, double width, double height)
    : figure_(figure),
      theme_(theme),
      size_(figureUnits(width), 0.0),
      inner_(figureUnits(width - 2.0 * FigureWords::border)),
      legend_(figure, theme, inner_),
      words_(figure.title, figure.caption, figure.note, width) {
  for (size_t i = 0; i < figure.panels.size(); ++i)
    panels_.emplace_back(
        figure.panels[i], theme,
        figure.labelled ? panelLabel(figure.firstLabel + i, figure.firstLabel + figure.panels.size()) : QString());
  layOut(figureUnits(height));
}

int FigurePainter::columnCount() const {
  const int count = std::max<int>(1, panels_.size());
  const int fitting =
      std::max(1, static_cast<int>((inner_ + figureUnits(columnGap)) / figureUnits(leastPanel + columnGap)));
  const int wanted = figure_.columns > 0 ? figure_.columns : fitting;
  const int columns = std::min({wanted, fitting, count});
  const int rows = (count + columns - 1) / columns;
  return figure_.columns > 0 ? columns : (count + rows - 1) / rows;  // no row with a single panel beside full ones
}

int FigurePainter::rowCount() const {
  const int columns = columnCount();
  return (static_cast<int>(panels_.size()) + columns - 1) / columns;
}

double FigurePainter::cellWidth() const {
  const int columns = columnCount();
  return (inner_ - (columns - 1) * figureUnits(columnGap)) / columns;
}

void FigurePainter::layOut(double height) {
  legendTop_ = figureUnits(FigureWords::border) + words_.titleHeight();
  const double top = legendTop_ + legend_.height() + figureUnits(1.2);
  const double below =
      (words_.belowHeight() > 0.0 ? figureUnits(2.0) : 0.0) + words_.belowHeight() + figureUnits(FigureWords::border);
  const int rows = rowCount();
  const double gaps = std::max(0, rows - 1) * figureUnits(rowGap);
  const double wantedPlot =
      std::min(std::max(figureUnits(leastHeight), plotShape * cellWidth()), figureUnits(mostHeight));
  const ChartPainter::Margins margins = commonMargins(wantedPlot);
  const double wanted = top + rows * (margins.top + wantedPlot + margins.bottom) + gaps + below;
  size_.setHeight(std::ceil(height > 0.0 ? height : wanted));
  textTop_ = size_.height() - figureUnits(FigureWords::border) - words_.belowHeight();
  placePanels(top, (size_.height() - top - below - gaps) / std::max(1, rows), margins);
}

ChartPainter::Margins FigurePainter::commonMargins(double plotHeight) const {
  ChartPainter::Margins common;
  for (const ChartPainter& panel : panels_) {
    const ChartPainter::Margins margins = panel.margins(cellWidth(), plotHeight);
    common.left = std::max(common.left, margins.left);
    common.top = std::max(common.top, margins.top);
    common.right = std::max(common.right, margins.right);
    common.bottom = std::max(common.bottom, margins.bottom);
  }
  return common;
}

void FigurePainter::placePanels(double top, double cellHeight, const ChartPainter::Margins& margins) {
  const int columns = columnCount();
  const QSizeF cell(cellWidth(), cellHeight);
  for (size_t i = 0; i < panels_.size(); ++i) {
    const double x = figureUnits(FigureWords::border) + (i % columns) * (cell.width() + figureUnits(columnGap));
    const double y = top + (i / columns) * (cell.height() + figureUnits(rowGap));
    panels_[i].place(QRectF(QPointF(x, y), cell), margins);
  }
}

void FigurePainter::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  if (theme_.background.isValid()) painter.fillRect(QRectF(QPointF(), size_), theme_.background);
  words_.paintTitle(painter, theme_);
  legend_.paint(painter, QPointF(figureUnits(FigureWords::border), legendTop_));
  for (const ChartPainter& panel : panels_) panel.paint(painter);
  words_.paintBelow(painter, theme_, textTop_);
}

}  // namespace mien
