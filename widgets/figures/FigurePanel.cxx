#include "FigurePanel.h"

#include <QPainter>

#include "FigurePainter.h"

namespace mien {

PlatePanel figurePanel(const std::string& heading, const Figure& figure, double width, double heightShare) {
  constexpr double border = FigureWords::border, unit = figureUnitsPerMillimetre;
  const double natural = FigurePainter(figure, FigureTheme::all().front(), width + 2.0 * border).size().height() / unit;
  const double height = heightShare * natural;
  const auto paint = [figure, height](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    painter.setClipRect(place.adjusted(-unit * border, 0.0, unit * border, 0.0));  // the plate has a background
    painter.translate(place.topLeft() - unit * QPointF(border, border));
    FigurePainter(figure, theme, place.width() / unit + 2.0 * border, height).paint(painter);
  };
  return {heading, 1, (height - 2.0 * border) / width, paint};
}

}  // namespace mien
