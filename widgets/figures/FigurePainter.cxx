#include "FigurePainter.h"

#include "TextLines.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace mien {

namespace {

constexpr double border = 1.5;        // mm
constexpr double leastPanel = 38.0;   // mm: narrower panels have no room for three numbers on their x axis
constexpr double leastHeight = 32.0;  // mm
constexpr double columnGap = 3.0;     // mm
constexpr double rowGap = 3.0;        // mm
constexpr double titleSize = 8.5, captionSize = 7.0, noteSize = 6.0;  // pt

double units(double millimetres) { return millimetres * figureUnitsPerMillimetre; }

QString panelLabel(size_t index, size_t count) {
  if (count < 2) return {};
  const QChar letter('a' + static_cast<char>(index % 26));
  return '(' + (index < 26 ? QString() : QString::number(index / 26)) + letter + ')';
}

}  // namespace

FigurePainter::FigurePainter(const Figure& figure, const FigureTheme& theme, double width, double height)
    : figure_(figure), theme_(theme), size_(units(width), 0.0), inner_(units(width - 2.0 * border)), legend_(figure, theme, inner_) {
  title_ = textLines(figureFont(titleSize, true), QString::fromStdString(figure.title), inner_);
  caption_ = textLines(figureFont(captionSize), QString::fromStdString(figure.caption), inner_);
  note_ = textLines(figureFont(noteSize), QString::fromStdString(figure.note), inner_);
  for (size_t i = 0; i < figure.panels.size(); ++i)
    panels_.emplace_back(figure.panels[i], theme, panelLabel(i, figure.panels.size()));
  layOut(units(height));
}

int FigurePainter::columnCount() const {
  const int count = std::max<int>(1, panels_.size());
  const int fitting = std::max(1, static_cast<int>((inner_ + units(columnGap)) / units(leastPanel + columnGap)));
  const int wanted = figure_.columns > 0 ? figure_.columns : fitting;
  const int columns = std::min({wanted, fitting, count});
  const int rows = (count + columns - 1) / columns;
  return figure_.columns > 0 ? columns : (count + rows - 1) / rows;  // no row with a single panel beside full ones
}

double FigurePainter::textHeight() const {
  return caption_.size() * lineHeight(figureFont(captionSize)) + note_.size() * lineHeight(figureFont(noteSize));
}

void FigurePainter::layOut(double height) {
  legendTop_ = units(border) + title_.size() * lineHeight(figureFont(titleSize)) + (title_.isEmpty() ? 0.0 : units(0.8));
  const double top = legendTop_ + legend_.height() + units(1.2);
  const int columns = columnCount(), rows = (static_cast<int>(panels_.size()) + columns - 1) / columns;
  const double panelWidth = (inner_ - (columns - 1) * units(columnGap)) / columns;
  const double panelHeight = std::max(units(leastHeight), (columns == 1 ? 0.62 : 0.8) * panelWidth);
  const double below = (textHeight() > 0.0 ? units(2.0) : 0.0) + textHeight() + units(border);
  const double wanted = top + rows * panelHeight + std::max(0, rows - 1) * units(rowGap) + below;
  size_.setHeight(std::ceil(height > 0.0 ? height : wanted));
  textTop_ = size_.height() - units(border) - textHeight();
  placePanels(top, size_.height() - below);
}

ChartPainter::Margins FigurePainter::commonMargins(const QSizeF& cell) const {
  ChartPainter::Margins common;
  for (const ChartPainter& panel : panels_) {
    const ChartPainter::Margins margins = panel.margins(cell);
    common.left = std::max(common.left, margins.left);
    common.top = std::max(common.top, margins.top);
    common.right = std::max(common.right, margins.right);
    common.bottom = std::max(common.bottom, margins.bottom);
  }
  return common;
}

void FigurePainter::placePanels(double top, double bottom) {
  if (panels_.empty()) return;
  const int columns = columnCount(), rows = (static_cast<int>(panels_.size()) + columns - 1) / columns;
  const QSizeF cell((inner_ - (columns - 1) * units(columnGap)) / columns, (bottom - top - (rows - 1) * units(rowGap)) / rows);
  const ChartPainter::Margins margins = commonMargins(cell);
  for (size_t i = 0; i < panels_.size(); ++i) {
    const double x = units(border) + (i % columns) * (cell.width() + units(columnGap));
    const double y = top + (i / columns) * (cell.height() + units(rowGap));
    panels_[i].place(QRectF(QPointF(x, y), cell), margins);
  }
}

double FigurePainter::paintLines(QPainter& painter, const QFont& font, const QStringList& lines, double y) const {
  painter.setFont(font);
  painter.setPen(theme_.text);
  for (const QString& line : lines) {
    painter.drawText(QPointF(units(border), y + 0.95 * font.pixelSize()), line);
    y += lineHeight(font);
  }
  return y;
}

void FigurePainter::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  if (theme_.background.isValid()) painter.fillRect(QRectF(QPointF(), size_), theme_.background);
  paintLines(painter, figureFont(titleSize, true), title_, units(border));
  legend_.paint(painter, QPointF(units(border), legendTop_));
  for (const ChartPainter& panel : panels_) panel.paint(painter);
  const double y = paintLines(painter, figureFont(captionSize), caption_, textTop_);
  paintLines(painter, figureFont(noteSize), note_, y);
}

}  // namespace mien
