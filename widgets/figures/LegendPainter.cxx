#include "LegendPainter.h"

#include <QPainter>
#include <algorithm>

#include "ChartPainter.h"
#include "OffScaleMarks.h"
#include "SeriesStyle.h"
#include "TextLines.h"

namespace mien {

namespace {

constexpr double textSize = 7.0;      // pt
constexpr double symbolWidth = 27.0;  // pt: long enough to show a pattern of dashes on both sides of the marker
constexpr double symbolGap = 4.0;     // pt
constexpr double entryGap = 12.0;     // pt

QFont legendFont() {
  return figureFont(textSize);
}

double rowHeight() {
  return 1.15 * lineHeight(legendFont());
}

}  // namespace

LegendPainter::LegendPainter(const Figure& figure, const FigureTheme& theme, double width) : theme_(theme) {
  collect(figure);
  place(width);
}

void LegendPainter::collect(const Figure& figure) {
  for (const Chart& chart : figure.panels)
    for (size_t i = 0; i < chart.series.size(); ++i) {
      const bool bars = chart.series[i].kind == ChartSeries::Kind::Bars;
      add(bars ? Entry::Kind::Bar : Entry::Kind::Line, chart.series[i].name, ChartPainter::styleOf(chart, i));
    }
  for (const Chart& chart : figure.panels)
    for (const ChartMark& mark : chart.marks) add(Entry::Kind::Mark, mark.name, 0);
  for (const Chart& chart : figure.panels)
    for (const ChartSeries& series : chart.series)
      if (series.breakdown) add(Entry::Kind::Breakdown, "breaks down here", 0);
  for (const Chart& chart : figure.panels)
    if (OffScaleMarks::areNeeded(chart)) add(Entry::Kind::OffScale, "off scale", 0);
}

void LegendPainter::add(Entry::Kind kind, const std::string& name, int style) {
  const QString text = QString::fromStdString(name);
  const auto same = [&](const Entry& entry) { return entry.name == text && entry.kind == kind; };
  if (text.isEmpty() || std::any_of(entries_.begin(), entries_.end(), same)) return;
  entries_.push_back({kind, text, style, QPointF()});
}

void LegendPainter::place(double width) {
  QPointF at(0.0, 0.0);
  rows_ = entries_.empty() ? 0 : 1;
  for (Entry& entry : entries_) {
    const double length = figureUnitsFromPoints(symbolWidth + symbolGap) + textWidth(legendFont(), entry.name);
    if (at.x() > 0.0 && at.x() + length > width) {
      at = QPointF(0.0, at.y() + rowHeight());
      ++rows_;
    }
    entry.place = at;
    at.rx() += length + figureUnitsFromPoints(entryGap);
  }
}

double LegendPainter::height() const {
  return rows_ * rowHeight();
}

void LegendPainter::paint(QPainter& painter, const QPointF& topLeft) const {
  for (const Entry& entry : entries_) {
    const QPointF left = topLeft + entry.place + QPointF(0.0, 0.5 * rowHeight());
    paintSymbol(painter, entry, left);
    painter.setFont(legendFont());
    painter.setPen(theme_.text);
    painter.drawText(left + QPointF(figureUnitsFromPoints(symbolWidth + symbolGap), 0.36 * legendFont().pixelSize()),
                     entry.name);
  }
}

void LegendPainter::paintSymbol(QPainter& painter, const Entry& entry, const QPointF& left) const {
  const SeriesStyle style(theme_, entry.style);
  const QPointF right = left + QPointF(figureUnitsFromPoints(symbolWidth), 0.0), middle = 0.5 * (left + right);
  QPen mark(theme_.axis, figureUnitsFromPoints(0.8 * theme_.lineWidth));
  mark.setDashPattern({3.0, 3.0});
  switch (entry.kind) {
    case Entry::Kind::Line:
      painter.setPen(style.linePen());
      painter.drawPolyline(QPolygonF() << left << right);
      style.drawMarker(painter, middle);
      break;
    case Entry::Kind::Bar:
      painter.setPen(Qt::NoPen);
      painter.setBrush(style.color());
      painter.drawRect(QRectF(left.x() + figureUnitsFromPoints(6.0), left.y() - figureUnitsFromPoints(2.5),
                              figureUnitsFromPoints(symbolWidth - 6.0), figureUnitsFromPoints(5.0)));
      break;
    case Entry::Kind::Mark:
      painter.setPen(mark);
      painter.drawLine(left, right);
      break;
    case Entry::Kind::Breakdown:
      painter.setPen(QPen(theme_.axis, figureUnitsFromPoints(0.5)));
      painter.drawLine(middle, middle + QPointF(0.0, figureUnitsFromPoints(4.0)));
      painter.setBrush(theme_.axis);
      painter.drawEllipse(middle, figureUnitsFromPoints(1.6), figureUnitsFromPoints(1.6));
      break;
    case Entry::Kind::OffScale:
      OffScaleMarks::paintOne(painter, middle - QPointF(0.0, figureUnitsFromPoints(2.0)), theme_.axis);
      break;
  }
}

}  // namespace mien
