#include "OverlaidPanel.h"

#include <QPainter>

#include "PicturePanel.h"
#include "PlaneDrawingPainter.h"

namespace mien {

PlatePanel overlaidPanel(const std::string& heading, const QImage& picture, const PlaneDrawing& drawing) {
  PlatePanel panel = picturePanel(heading, picture);
  const QRectF shown(0.0, 0.0, picture.width(), picture.height());
  panel.paint = [below = panel.paint, drawing, shown](QPainter& painter, const QRectF& place,
                                                      const FigureTheme& theme) {
    below(painter, place, theme);
    painter.setClipRect(place, Qt::IntersectClip);
    PlaneDrawingPainter(drawing, place, shown).paint(painter, theme);
  };
  return panel;
}

}  // namespace mien
