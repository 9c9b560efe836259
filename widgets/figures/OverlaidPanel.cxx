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
    const FigureTheme& onPicture = *FigureTheme::find("light");  // what lies behind is the picture, not the page
    PlaneDrawingPainter(drawing, place, shown, PlaneDrawingPainter::Margin::None).paint(painter, onPicture);
  };
  return panel;
}

}  // namespace mien
