#include "FigurePanel.h"

#include <QPainter>

#include "FigurePainter.h"

namespace mien {

PlatePanel figurePanel(const std::string& heading, const Figure& figure, double width) {
  const QSizeF size = FigurePainter(figure, FigureTheme::all().front(), width).size();
  const auto paint = [figure](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    painter.translate(place.topLeft());
    FigurePainter(figure, theme, place.width() / figureUnitsPerMillimetre).paint(painter);
  };
  return {heading, 1, size.height() / size.width(), paint};
}

}  // namespace mien
