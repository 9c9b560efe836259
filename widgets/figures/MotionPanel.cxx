#include "MotionPanel.h"

#include <QPainter>
#include <memory>

namespace mien {

PlatePanel motionPanel(const std::string& heading, const std::vector<MotionVectorPanel>& fields,
                       const MotionVectorOptions& options) {
  const auto figure = std::make_shared<MotionVectorFigure>(fields, options);
  const auto paint = [figure](QPainter& painter, const QRectF& place, const FigureTheme&) {
    painter.translate(place.topLeft());
    figure->paint(painter);
  };
  return {heading, 1, figure->size().height() / figure->size().width(), paint};
}

}  // namespace mien
