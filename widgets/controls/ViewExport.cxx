#include "ViewExport.h"

#include <QPainter>
#include <QPointer>
#include <QWidget>
#include <algorithm>

#include "RenderView.h"
#include "Theme.h"
#include "ViewPicture.h"

namespace mien {

namespace {

constexpr double usualWidth = 85.0;             // mm, one column of a page
constexpr double keyPixelsPerMillimetre = 4.8;  // letters of about 6 pt

/// The colours of the screen on the page of the figure.
Theme themeOf(const ExportOptions& options) {
  Theme theme = Theme::of(options.theme == "dark" ? Theme::Kind::Dark : Theme::Kind::Light);
  theme.viewTop = theme.viewBottom = options.figureTheme().background;
  return theme;
}

/// As many pixels as were asked for, or fewer where the page has fewer.
QSize pixelsOf(const QSizeF& size, const ExportOptions& options, const QPainter& painter) {
  const double inch = 25.4 * figureUnitsPerMillimetre;
  const double scale = std::min(options.dotsPerInch / inch, painter.combinedTransform().m11());
  return (size * scale).toSize();
}

void paintKey(QPainter& painter, QWidget* key, const QRectF& place) {
  const double scale = figureUnitsPerMillimetre / keyPixelsPerMillimetre;
  const QSize before = key->size();
  key->resize((place.size() / scale).toSize());
  painter.save();
  painter.translate(place.topLeft());
  painter.scale(scale, scale);
  key->render(&painter, QPoint(), QRegion(), QWidget::DrawChildren);
  painter.restore();
  key->resize(before);
}

}  // namespace

ExportDrawing viewDrawing(RenderView* view, QWidget* key, const std::string& title, const ExportOptions& options) {
  ExportDrawing drawing;
  drawing.title = title;
  const double width = (options.width > 0.0 ? options.width : usualWidth) * figureUnitsPerMillimetre;
  const QSizeF face(width, width * view->height() / std::max(1, view->width()));
  const bool hasKey = key && key->isVisibleTo(view->window());
  const double keyHeight = hasKey ? key->sizeHint().height() * figureUnitsPerMillimetre / keyPixelsPerMillimetre : 0.0;
  drawing.size = face + QSizeF(0.0, keyHeight);
  const QPointer<RenderView> shown(view);
  const QPointer<QWidget> below(key);
  drawing.paint = [=](QPainter& painter) {
    if (!shown) return;
    const Theme theme = themeOf(options);
    {
      const BorrowedTheme borrowed(theme);
      painter.fillRect(QRectF(QPointF(), face + QSizeF(0.0, keyHeight)), theme.viewTop);
      painter.drawImage(QRectF(QPointF(), face), viewPicture(shown, pixelsOf(face, options, painter)));
      if (hasKey && below) paintKey(painter, below, QRectF(0.0, face.height(), width, keyHeight));
    }
    shown->useTheme();
  };
  return drawing;
}

}  // namespace mien
