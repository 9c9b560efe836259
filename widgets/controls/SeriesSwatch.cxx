#include "SeriesSwatch.h"

#include <QPainter>
#include <QPixmap>

#include "ScreenFigure.h"
#include "SeriesStyle.h"

namespace mien {

namespace {

constexpr double scale = 0.045;  // pixels per figure unit

}  // namespace

QIcon seriesSwatch(int style) {
  QPixmap picture(2 * swatchSize);
  picture.fill(Qt::transparent);
  if (style < 0) return QIcon(picture);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(2.0 * scale, 2.0 * scale);
  const SeriesStyle drawn(screenTheme(), style);
  const double width = swatchSize.width() / scale, middle = 0.5 * swatchSize.height() / scale;
  painter.setPen(drawn.linePen());
  painter.drawLine(QPointF(0.0, middle), QPointF(width, middle));
  drawn.drawMarker(painter, {0.5 * width, middle});
  return QIcon(picture);
}

}  // namespace mien
