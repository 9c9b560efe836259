#include "PicturePanel.h"

#include <QPainter>
#include <algorithm>

namespace mien {

namespace {

/// Without transparent pixels, which would be a mask of their own in a PDF file.
QImage opaque(const QImage& picture, const FigureTheme& theme) {
  if (!picture.hasAlphaChannel() || !theme.background.isValid()) return picture;
  QImage image(picture.size(), QImage::Format_RGB32);
  image.fill(theme.background);
  QPainter(&image).drawImage(0, 0, picture);
  return image;
}

}  // namespace

PlatePanel picturePanel(const std::string& heading, const QImage& picture) {
  const auto paint = [picture](QPainter& painter, const QRectF& place, const FigureTheme& theme) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(place, opaque(picture, theme));
  };
  return {heading, 1, static_cast<double>(picture.height()) / std::max(picture.width(), 1), paint};
}

}  // namespace mien
