#include "ChartPanel.h"

#include <QPainter>

#include "ChartPainter.h"
#include "Figure.h"
#include "LegendPainter.h"

namespace mien {

PlatePanel chartPanel(const Chart& chart, double shape) {
  const auto paint = [chart](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    Figure figure;
    figure.panels.push_back(chart);
    const LegendPainter legend(figure, theme, place.width());
    legend.paint(painter, place.topLeft());
    const QRectF cell = place.adjusted(0.0, legend.height() + figureUnitsPerMillimetre, 0.0, 0.0);
    ChartPainter panel(chart, theme, QString());
    panel.place(cell, panel.margins(cell.width(), cell.height()));
    panel.paint(painter);
  };
  return {"", 1, shape, paint};
}

}  // namespace mien
