#include "BreakdownFlags.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "ChartPainter.h"
#include "SeriesStyle.h"

namespace mien {

namespace {

constexpr int levels = 3;
constexpr double lowest = 2.4, step = 4.8,
                 room =
                     2.4;  // pt: of the markers' middles above the plot, on whose edge the lowest stand; above the last
constexpr double apart = 5.2;                       // pt, between markers at one height
constexpr double stemDepth = 2.0, stemWidth = 0.5;  // pt

}  // namespace

double BreakdownFlags::height(const Chart& chart) {
  const auto count = std::count_if(chart.series.begin(), chart.series.end(),
                                   [](const ChartSeries& series) { return series.breakdown.has_value(); });
  const double stacked = std::min<double>(levels, count) - 1.0;
  return count > 0 ? figureUnitsFromPoints(lowest + stacked * step + room) : 0.0;
}

void BreakdownFlags::paint(QPainter& painter, const QRectF& plot, const AxisScale& x) const {
  std::vector<std::pair<double, std::size_t>> flags;
  for (std::size_t i = 0; i < chart_.series.size(); ++i)
    if (chart_.series[i].breakdown)
      flags.emplace_back(plot.left() + x.fraction(*chart_.series[i].breakdown) * plot.width(), i);
  std::sort(flags.begin(), flags.end());
  painter.setPen(QPen(theme_.grid, figureUnitsFromPoints(theme_.axisWidth)));
  if (!flags.empty()) painter.drawLine(plot.topLeft(), plot.topRight());
  const double depth = flags.size() == 1 ? plot.height() : figureUnitsFromPoints(stemDepth);
  std::array<double, levels> ends;
  ends.fill(-1e9);
  for (const auto& [at, series] : flags) {
    if (at < plot.left() - 1.0 || at > plot.right() + 1.0) continue;
    const auto free =
        std::find_if(ends.begin(), ends.end(), [&](double end) { return at - end >= figureUnitsFromPoints(apart); });
    const auto level = free != ends.end() ? free : std::min_element(ends.begin(), ends.end());
    *level = at;
    const SeriesStyle style(theme_, ChartPainter::styleOf(chart_, series));
    const QPointF middle(at,
                         plot.top() - figureUnitsFromPoints(lowest + step * static_cast<double>(level - ends.begin())));
    QPen stem(style.color(), figureUnitsFromPoints(stemWidth));
    if (flags.size() == 1) stem.setDashPattern({1.0, 4.0});
    painter.setPen(stem);
    painter.drawLine(middle, QPointF(at, plot.top() + depth));
    style.drawMarker(painter, middle);
  }
}

}  // namespace mien
