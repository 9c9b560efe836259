#include "ChartPainter.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>

#include "BreakdownFlags.h"
#include "LineClip.h"
#include "OffScaleMarks.h"
#include "SeriesStyle.h"
#include "TextLines.h"

namespace mien {

namespace {

constexpr double numberSize = 6.5;   // pt
constexpr double headingSize = 7.5;  // pt
constexpr double tickLength = 2.0;   // pt
constexpr double tickGap = 2.5;      // pt, between ticks, numbers and titles
constexpr double spread = 26.0;      // pt, at least, between the few markers that tell lines apart
constexpr double spreadShare = 9.0;  // pt, for each series: where lines coincide their markers stand apart
constexpr double brokenWidth = 0.5;  // of a line, from where its values mean nothing
constexpr double barShare = 0.8;     // of the room between two categories
constexpr int mostNumbers = 8;       // below a plot, however wide it is

std::vector<double> finiteValues(const Chart& chart, bool ofX) {
  std::vector<double> values;
  for (const ChartSeries& series : chart.series)
    for (const double value : ofX ? series.x : series.y)
      if (std::isfinite(value)) values.push_back(value);
  for (const ChartMark& mark : chart.marks)
    if (mark.horizontal != ofX) values.push_back(mark.value);
  return values;
}

/// A logarithmic axis has no place for 0: lines break there.
bool hasPlace(const AxisScale& scale, double value) {
  return std::isfinite(value) && (value > 0.0 || !scale.logarithmic());
}

bool isBars(const ChartSeries& series) {
  return series.kind == ChartSeries::Kind::Bars;
}

size_t barCount(const Chart& chart) {
  return std::count_if(chart.series.begin(), chart.series.end(), isBars);
}

/// Beginning and width of the bar of a series around its category, in units of x.
std::pair<double, double> barPlace(const Chart& chart, size_t series) {
  const double width = barShare / barCount(chart);
  const size_t before = std::count_if(chart.series.begin(), chart.series.begin() + series, isBars);
  return {-0.5 * barShare + before * width, width};
}

using TickSize = std::function<double(const AxisTick&)>;

/// Whether no text of an axis touches the one before it.
bool keepApart(const AxisScale& scale, const std::vector<AxisTick>& ticks, double length, const TickSize& sizeOf) {
  double end = -1e9;
  for (const AxisTick& tick : ticks) {
    if (tick.text.empty()) continue;
    const double half = 0.5 * sizeOf(tick), middle = scale.fraction(tick.value) * length;
    if (middle - half < end) return false;
    end = middle + half;
  }
  return true;
}

/// The most ticks whose texts keep apart; where not even two numbers do, the first and the last text.
std::vector<AxisTick> fittingTicks(const AxisScale& scale, const ChartAxis& axis, int most, double length,
                                   const TickSize& sizeOf) {
  std::vector<AxisTick> ticks;
  for (; most > 0; --most) {
    ticks = scale.ticks(axis, most);
    if (keepApart(scale, ticks, length, sizeOf)) return ticks;
  }
  const auto hasText = [](const AxisTick& tick) { return !tick.text.empty(); };
  const auto first = std::find_if(ticks.begin(), ticks.end(), hasText);
  const auto last = std::find_if(ticks.rbegin(), ticks.rend(), hasText).base();
  for (auto tick = first; tick != ticks.end() && tick + 1 < last; ++tick)
    if (tick != first) tick->text.clear();
  return ticks;
}

}  // namespace

ChartPainter::ChartPainter(const Chart& chart, const FigureTheme& theme, const QString& label)
    : chart_(chart),
      theme_(theme),
      label_(label),
      x_(AxisScale::around(chart.x, finiteValues(chart, true), false)),
      y_(AxisScale::around(chart.y, finiteValues(chart, false), barCount(chart) > 0)) {}

int ChartPainter::styleOf(const Chart& chart, size_t series) {
  const int style = chart.series[series].style;
  return style >= 0 ? style : static_cast<int>(series);
}

QString ChartPainter::heading() const {
  const QString title = QString::fromStdString(titleWithUnit(chart_.y));
  return label_.isEmpty() ? title : label_ + ' ' + title;
}

QStringList ChartPainter::xTitleLines(double cellWidth) const {
  const QString title = QString::fromStdString(titleWithUnit(chart_.x));
  return title.isEmpty() ? QStringList() : textLines(figureFont(numberSize), title, cellWidth);
}

double ChartPainter::categoryWidth() const {
  double width = 0.0;
  for (const std::string& name : chart_.x.categories)
    width = std::max(width, textWidth(figureFont(numberSize), QString::fromStdString(name)));
  return width;
}

/// Whether every `step`-th name and the last one stand beside each other without touching.
bool ChartPainter::namesFit(double plotWidth, size_t step) const {
  const std::vector<std::string>& names = chart_.x.categories;
  const QFont font = figureFont(numberSize);
  for (size_t i = 0; i + step < names.size(); i += step) {
    const double widths =
        textWidth(font, QString::fromStdString(names[i])) + textWidth(font, QString::fromStdString(names[i + step]));
    if (0.5 * widths + figureUnitsFromPoints(tickGap) > step * plotWidth / names.size()) return false;
  }
  return true;
}

/// Whether names would run into each other beside each other, but not on their sides.
bool ChartPainter::namesStandUpright(double plotWidth) const {
  const bool room = plotWidth / std::max<size_t>(chart_.x.categories.size(), 1) >= figureFont(numberSize).pixelSize();
  return room && !namesFit(plotWidth, 1);
}

/// All names, or, where that are too many, every second, fifth, tenth .. and the last.
std::vector<AxisTick> ChartPainter::nameTicks(double plotWidth) const {
  std::vector<AxisTick> ticks = x_.ticks(chart_.x, 0);
  if (namesStandUpright(plotWidth) || namesFit(plotWidth, 1)) return ticks;
  const QFont font = figureFont(numberSize);
  size_t step = 2;
  while (step < ticks.size() && !namesFit(plotWidth, step)) step = step == 2 ? 5 : 2 * step;
  const double last = 0.5 * textWidth(font, QString::fromStdString(ticks.back().text));
  for (size_t i = 0; i + 1 < ticks.size(); ++i) {
    const double half = 0.5 * textWidth(font, QString::fromStdString(ticks[i].text));
    const bool meetsLast =
        half + last + figureUnitsFromPoints(tickGap) > (ticks.size() - 1 - i) * plotWidth / ticks.size();
    if (i % step != 0 || meetsLast) ticks[i].text.clear();
  }
  return ticks;
}

/// How far the last name reaches beyond the plot.
double ChartPainter::overhang(double plotWidth) const {
  if (chart_.x.categories.empty() || namesStandUpright(plotWidth)) return 0.0;
  const double width = textWidth(figureFont(numberSize), QString::fromStdString(chart_.x.categories.back()));
  return std::max(0.0, 0.5 * (width - plotWidth / chart_.x.categories.size()));
}

/// From the plot to below the numbers.
double ChartPainter::numberDepth(double plotWidth) const {
  return figureUnitsFromPoints(tickLength + tickGap) +
         (namesStandUpright(plotWidth) ? categoryWidth() : lineHeight(figureFont(numberSize)));
}

/// As many numbers as stand above each other with room between them.
std::vector<AxisTick> ChartPainter::yTicks(double plotHeight) const {
  const double line = lineHeight(figureFont(numberSize));
  const int most = std::max(2, static_cast<int>(plotHeight / (1.9 * line)));
  return fittingTicks(y_, chart_.y, most, plotHeight, [line](const AxisTick&) { return line; });
}

/// As many numbers as stand beside each other with room between them.
std::vector<AxisTick> ChartPainter::xTicks(double plotWidth) const {
  if (!chart_.x.categories.empty()) return nameTicks(plotWidth);
  return fittingTicks(x_, chart_.x, mostNumbers, plotWidth, [](const AxisTick& tick) {
    return textWidth(figureFont(numberSize), QString::fromStdString(tick.text)) + figureUnitsFromPoints(2.0 * tickGap);
  });
}

ChartPainter::Margins ChartPainter::margins(double cellWidth, double plotHeight) const {
  const QFont font = figureFont(numberSize), large = figureFont(headingSize);
  Margins margins;
  margins.top = textLines(large, heading(), cellWidth).size() * lineHeight(large) +
                figureUnitsFromPoints(2.0 * tickGap) + BreakdownFlags::height(chart_);
  for (const AxisTick& tick : yTicks(plotHeight))
    margins.left = std::max(margins.left, textWidth(font, QString::fromStdString(tick.text)));
  margins.left += figureUnitsFromPoints(tickLength + tickGap);
  const double plotWidth = cellWidth - margins.left - figureUnitsFromPoints(2.0 * tickGap);
  margins.bottom = numberDepth(plotWidth) + xTitleLines(cellWidth).size() * lineHeight(font);
  margins.right = figureUnitsFromPoints(2.0 * tickGap) + overhang(plotWidth);
  return margins;
}

void ChartPainter::place(const QRectF& cell, const Margins& margins) {
  cell_ = cell;
  plot_ = cell.adjusted(margins.left, margins.top, -margins.right, -margins.bottom);
}

QPointF ChartPainter::position(double x, double y) const {
  return {plot_.left() + x_.fraction(x) * plot_.width(), plot_.bottom() - y_.fraction(y) * plot_.height()};
}

void ChartPainter::paint(QPainter& painter) const {
  paintHeading(painter);
  paintYAxis(painter);
  paintXAxis(painter);
  paintMarks(painter);
  for (size_t i = 0; i < chart_.series.size(); ++i)
    isBars(chart_.series[i]) ? paintBars(painter, i) : paintLine(painter, i);
  for (size_t i = 0; i < chart_.series.size(); ++i) paintMarkers(painter, i);
  paintFrame(painter);
  BreakdownFlags(chart_, theme_).paint(painter, plot_, x_);
}

void ChartPainter::paintHeading(QPainter& painter) const {
  const QFont font = figureFont(headingSize), bold = figureFont(headingSize, true);
  const QStringList lines = textLines(font, heading(), cell_.width());
  painter.setPen(theme_.text);
  double y = plot_.top() - figureUnitsFromPoints(2.2 * tickGap) - BreakdownFlags::height(chart_) -
             (lines.size() - 1) * lineHeight(font);
  for (int i = 0; i < lines.size(); ++i) {
    const QString label = i == 0 && lines[i].startsWith(label_) ? label_ : QString();
    painter.setFont(bold);
    painter.drawText(QPointF(cell_.left(), y), label);
    painter.setFont(font);
    painter.drawText(QPointF(cell_.left() + textWidth(bold, label), y), lines[i].mid(label.size()));
    y += lineHeight(font);
  }
}

void ChartPainter::paintYAxis(QPainter& painter) const {
  const QFont font = figureFont(numberSize);
  painter.setFont(font);
  for (const AxisTick& tick : yTicks(plot_.height())) {
    const double y = position(x_.begin(), tick.value).y();
    const QString text = QString::fromStdString(tick.text);
    if (!text.isEmpty()) {
      painter.setPen(QPen(theme_.grid, figureUnitsFromPoints(theme_.axisWidth)));
      painter.drawLine(QPointF(plot_.left(), y), QPointF(plot_.right(), y));
    }
    painter.setPen(QPen(theme_.axis, figureUnitsFromPoints(theme_.axisWidth)));
    painter.drawLine(QPointF(plot_.left() - figureUnitsFromPoints(text.isEmpty() ? 0.5 * tickLength : tickLength), y),
                     QPointF(plot_.left(), y));
    painter.setPen(theme_.text);
    const double x = plot_.left() - figureUnitsFromPoints(tickLength + 0.5 * tickGap) - textWidth(font, text);
    if (!text.isEmpty()) painter.drawText(QPointF(x, y + 0.36 * font.pixelSize()), text);
  }
}

void ChartPainter::paintXAxis(QPainter& painter) const {
  const QFont font = figureFont(numberSize);
  painter.setFont(font);
  for (const AxisTick& tick : xTicks(plot_.width())) {
    const double x = plot_.left() + x_.fraction(tick.value) * plot_.width();
    const QString text = QString::fromStdString(tick.text);
    painter.setPen(QPen(theme_.axis, figureUnitsFromPoints(theme_.axisWidth)));
    painter.drawLine(
        QPointF(x, plot_.bottom()),
        QPointF(x, plot_.bottom() + figureUnitsFromPoints(text.isEmpty() ? 0.5 * tickLength : tickLength)));
    painter.setPen(theme_.text);
    if (!text.isEmpty()) paintCategory(painter, x, text);
  }
  double y = plot_.bottom() + numberDepth(plot_.width()) + 0.9 * font.pixelSize();
  for (const QString& line : xTitleLines(cell_.width())) {
    const double width = textWidth(font, line), most = std::max(cell_.left(), cell_.right() - width);
    painter.drawText(QPointF(std::clamp(plot_.center().x() - 0.5 * width, cell_.left(), most), y), line);
    y += lineHeight(font);
  }
}

void ChartPainter::paintCategory(QPainter& painter, double x, const QString& text) const {
  const QFont font = figureFont(numberSize);
  const double top = plot_.bottom() + figureUnitsFromPoints(tickLength + 0.5 * tickGap), width = textWidth(font, text);
  if (chart_.x.categories.empty() || !namesStandUpright(plot_.width())) {
    painter.drawText(QPointF(x - 0.5 * width, top + 0.9 * font.pixelSize()), text);
    return;
  }
  painter.save();
  painter.translate(x + 0.36 * font.pixelSize(), top + width);
  painter.rotate(-90.0);
  painter.drawText(QPointF(0.0, 0.0), text);
  painter.restore();
}

void ChartPainter::paintFrame(QPainter& painter) const {
  painter.setPen(QPen(theme_.axis, figureUnitsFromPoints(theme_.axisWidth)));
  painter.drawLine(plot_.bottomLeft(), plot_.bottomRight());
  painter.drawLine(plot_.topLeft(), plot_.bottomLeft());
}

void ChartPainter::paintMarks(QPainter& painter) const {
  QPen pen(theme_.axis, figureUnitsFromPoints(0.8 * theme_.lineWidth));
  pen.setDashPattern({3.0, 3.0});
  painter.setPen(pen);
  for (const ChartMark& mark : chart_.marks) {
    const QPointF at = mark.horizontal ? position(x_.begin(), mark.value) : position(mark.value, y_.begin());
    if (mark.horizontal)
      painter.drawLine(QPointF(plot_.left(), at.y()), QPointF(plot_.right(), at.y()));
    else
      painter.drawLine(QPointF(at.x(), plot_.top()), QPointF(at.x(), plot_.bottom()));
  }
}

void ChartPainter::paintBars(QPainter& painter, size_t index) const {
  const ChartSeries& series = chart_.series[index];
  const auto [begin, width] = barPlace(chart_, index);
  painter.setPen(Qt::NoPen);
  painter.setBrush(SeriesStyle(theme_, styleOf(chart_, index)).color());
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (!std::isfinite(series.y[i])) continue;
    const QPointF corner = position(series.x[i] + begin, series.y[i]);
    const QPointF opposite = position(series.x[i] + begin + 0.92 * width, y_.base());
    painter.drawRect(QRectF(corner, opposite).normalized() & plot_);
  }
}

std::vector<QPolygonF> ChartPainter::unbrokenLines(const ChartSeries& series) const {
  std::vector<QPolygonF> lines(1);
  for (size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (hasPlace(x_, series.x[i]) && hasPlace(y_, series.y[i]))
      lines.back() << position(series.x[i], series.y[i]);
    else if (!lines.back().isEmpty())
      lines.emplace_back();
  }
  return lines;
}

void ChartPainter::paintLine(QPainter& painter, size_t index) const {
  const ChartSeries& series = chart_.series[index];
  const SeriesStyle style(theme_, styleOf(chart_, index));
  const QRectF sound =
      series.breakdown ? plot_ & QRectF(plot_.topLeft(), position(*series.breakdown, y_.begin())) : plot_;
  for (const QPolygonF& line : unbrokenLines(series)) {
    painter.setPen(style.linePen());
    for (const QPolygonF& part : clippedLine(line, sound)) painter.drawPolyline(part);
    if (chart_.y.end) OffScaleMarks::paint(painter, line, plot_, style.color());
    if (!series.breakdown) continue;
    painter.setPen(style.linePen(brokenWidth));
    for (const QPolygonF& part : clippedLine(line, QRectF(sound.topRight(), plot_.bottomRight()) & plot_))
      painter.drawPolyline(part);
  }
}

/// Lines of different series have their markers at different places, so that they stay visible where lines coincide.
void ChartPainter::paintMarkers(QPainter& painter, size_t index) const {
  const ChartSeries& series = chart_.series[index];
  if (isBars(series) || (series.kind == ChartSeries::Kind::Line && chart_.series.size() == 1)) return;
  const SeriesStyle style(theme_, styleOf(chart_, index));
  const QRectF around = plot_.adjusted(-1.0, -1.0, 1.0, 1.0);  // rounding
  const double distance = figureUnitsFromPoints(std::max(spread, spreadShare * chart_.series.size()));
  double next = plot_.left() + distance * (0.3 + index) / chart_.series.size();
  for (const QPolygonF& line : unbrokenLines(series))
    for (const QPointF& point : line) {
      if (!around.contains(point) || (series.kind == ChartSeries::Kind::Line && point.x() < next)) continue;
      style.drawMarker(painter, point);
      while (next <= point.x()) next += distance;
    }
}

}  // namespace mien
