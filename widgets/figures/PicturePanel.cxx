#include "PicturePanel.h"

#include <QPainter>
#include <algorithm>

namespace mien {

PlatePanel picturePanel(const std::string& heading, const QImage& picture) {
  const auto paint = [picture](QPainter& painter, const QRectF& place, const FigureTheme&) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, picture);
  };
  return {heading, 1, static_cast<double>(picture.height()) / std::max(picture.width(), 1), paint};
}

}  // namespace mien
