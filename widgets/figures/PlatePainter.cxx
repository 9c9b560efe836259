#include "PlatePainter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "PanelLabel.h"
#include "TextLines.h"

namespace mien {

namespace {

constexpr double panelGap = 2.5, plateRowGap = 2.5;      // mm
constexpr double headingGap = 0.6, plateWordsGap = 1.5;  // mm
constexpr double plateHeadingSize = 7.0;                 // pt

}  // namespace

PlatePainter::PlatePainter(const Plate& plate, const FigureTheme& theme, double width, bool labelled)
    : plate_(plate),
      theme_(theme),
      words_(plate.title, plate.caption, plate.note, width),
      labelled_(labelled),
      places_(plate.panels.size()) {
  layOut(width);
}

double PlatePainter::panelWidth(double width, int columns, int span) {
  const double inner = width - 2.0 * FigureWords::border;
  const double column = (inner - (columns - 1) * panelGap) / columns;
  return span * column + (span - 1) * panelGap;
}

size_t PlatePainter::endOfRow(size_t begin) const {
  int used = 0;
  size_t end = begin;
  while (end < plate_.panels.size() && (end == begin || used + plate_.panels[end].span <= plate_.columns))
    used += plate_.panels[end++].span;
  return end;
}

QString PlatePainter::labelOf(size_t panel) const {
  const std::string& own = plate_.panels[panel].label;
  if (!own.empty()) return QString::fromStdString(own);
  return labelled_ ? panelLabel(panel, plate_.panels.size()) : QString();
}

bool PlatePainter::hasHeading(size_t panel) const {
  return !plate_.panels[panel].heading.empty() || !labelOf(panel).isEmpty();
}

/// @return the y below the row
double PlatePainter::placeRow(size_t begin, size_t end, double top, double width) {
  double x = figureUnits(FigureWords::border), heading = 0.0, height = 0.0;
  for (size_t i = begin; i < end; ++i)
    if (hasHeading(i)) heading = lineHeight(figureFont(plateHeadingSize)) + figureUnits(headingGap);
  for (size_t i = begin; i < end; ++i) {
    const double panel =
        figureUnits(panelWidth(width, plate_.columns, std::min(plate_.panels[i].span, plate_.columns)));
    places_[i] = QRectF(x, top + heading, panel, panel * plate_.panels[i].shape);
    height = std::max(height, places_[i].height());
    x += panel + figureUnits(panelGap);
  }
  return top + heading + height;
}

void PlatePainter::layOut(double width) {
  double y = figureUnits(FigureWords::border) + words_.titleHeight();
  for (size_t begin = 0; begin < places_.size();) {
    const size_t end = endOfRow(begin);
    y = placeRow(begin, end, y + (begin > 0 ? figureUnits(plateRowGap) : 0.0), width);
    begin = end;
  }
  wordsTop_ = y + (words_.belowHeight() > 0.0 ? figureUnits(plateWordsGap) : 0.0);
  size_ = QSizeF(figureUnits(width), std::ceil(wordsTop_ + words_.belowHeight() + figureUnits(FigureWords::border)));
}

void PlatePainter::paintHeading(QPainter& painter, size_t panel) const {
  const QFont bold = figureFont(plateHeadingSize, true), plain = figureFont(plateHeadingSize);
  const QString label = labelOf(panel);
  QPointF place = places_[panel].topLeft() - QPointF(0.0, figureUnits(headingGap) + 0.25 * plain.pixelSize());
  painter.setPen(theme_.text);
  painter.setFont(bold);
  painter.drawText(place, label);
  if (!label.isEmpty()) place.rx() += textWidth(bold, label) + 0.4 * plain.pixelSize();
  painter.setFont(plain);
  painter.drawText(place, QString::fromStdString(plate_.panels[panel].heading));
}

void PlatePainter::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  if (theme_.background.isValid()) painter.fillRect(QRectF(QPointF(), size_), theme_.background);
  words_.paintTitle(painter, theme_);
  for (size_t i = 0; i < places_.size(); ++i) {
    if (hasHeading(i)) paintHeading(painter, i);
    painter.save();
    plate_.panels[i].paint(painter, places_[i], theme_);
    painter.restore();
  }
  words_.paintBelow(painter, theme_, wordsTop_);
}

}  // namespace mien
