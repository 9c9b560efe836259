#include "ViewExport.h"

#include <QPainter>
#include <QPointer>
#include <QWidget>
#include <algorithm>
#include <memory>

#include "FigureWords.h"
#include "RenderView.h"
#include "Theme.h"
#include "ViewPicture.h"

namespace mien {

namespace {

constexpr double usualWidth = 85.0;             // mm, one column of a page
constexpr double panelGap = 2.0;                // mm, between views
constexpr double keyPixelsPerMillimetre = 4.8;  // letters of about 6 pt

/// The colours of the screen on the page of the figure.
Theme themeOf(const ExportOptions& options) {
  Theme theme = Theme::of(options.theme == "dark" ? Theme::Kind::Dark : Theme::Kind::Light);
  theme.viewTop = theme.viewBottom = theme.panel = options.figureTheme().background;
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

/// Where everything stands on the page, figure units.
class ViewPage {
 public:
  ViewPage(const std::vector<ViewPanel>& panels, QWidget* key, const std::string& note, const ExportOptions& options)
      : views_(panels.size()), key_(key), options_(options) {
    const double count = static_cast<double>(panels.size());
    const double usual = panels.size() > 1 ? ExportDrawing::pageWidth : usualWidth;
    const double millimetres = options.width > 0.0 ? options.width : usual;
    width_ = millimetres * figureUnitsPerMillimetre;
    face_.setWidth((width_ - (count - 1.0) * gap()) / count);
    const RenderView* first = panels.front().view;
    face_.setHeight(face_.width() * first->freeHeight() / std::max(1, first->width()));
    for (size_t i = 0; i < panels.size(); ++i) {
      views_[i] = panels[i].view;
      captions_.emplace_back("", panels[i].caption, "", face_.width() / figureUnitsPerMillimetre);
      captionHeight_ = std::max(captionHeight_, captions_.back().belowHeight());
    }
    if (key && key->isVisibleTo(key->window()))
      keyHeight_ =
          std::max(key->sizeHint().height(), key->minimumHeight()) * figureUnitsPerMillimetre / keyPixelsPerMillimetre;
    note_ = FigureWords("", "", note, millimetres);
  }

  QSizeF size() const { return {width_, keyTop() + keyHeight_ + note_.belowHeight() + (hasWords() ? gap() : 0.0)}; }

  void paint(QPainter& painter) const {
    const Theme theme = themeOf(options_);
    {
      const BorrowedTheme borrowed(theme);
      painter.fillRect(QRectF(QPointF(), size()), theme.viewTop);
      for (size_t i = 0; i < views_.size(); ++i) paintView(painter, i);
      if (keyHeight_ > 0.0 && key_) paintKey(painter, key_, QRectF(0.0, keyTop(), width_, keyHeight_));
    }
    note_.paintBelow(painter, options_.figureTheme(), keyTop() + keyHeight_);
    for (const QPointer<RenderView>& view : views_)
      if (view) view->useTheme();
  }

 private:
  static double gap() { return panelGap * figureUnitsPerMillimetre; }
  double keyTop() const { return face_.height() + captionHeight_; }
  bool hasWords() const { return captionHeight_ + note_.belowHeight() > 0.0; }

  void paintView(QPainter& painter, size_t index) const {
    if (!views_[index]) return;
    painter.save();
    painter.translate(index * (face_.width() + gap()), 0.0);
    painter.drawImage(QRectF(QPointF(), face_), viewPicture(views_[index], pixelsOf(face_, options_, painter)));
    captions_[index].paintBelow(painter, options_.figureTheme(), face_.height());
    painter.restore();
  }

  std::vector<QPointer<RenderView>> views_;
  std::vector<FigureWords> captions_;
  FigureWords note_{"", "", "", usualWidth};
  QPointer<QWidget> key_;
  ExportOptions options_;
  QSizeF face_;
  double width_ = 0.0, captionHeight_ = 0.0, keyHeight_ = 0.0;
};

}  // namespace

ExportDrawing viewDrawing(const std::vector<ViewPanel>& panels, QWidget* key, const std::string& title,
                          const std::string& note, const ExportOptions& options) {
  const auto page = std::make_shared<ViewPage>(panels, key, note, options);
  ExportDrawing drawing;
  drawing.title = title;
  drawing.size = page->size();
  drawing.paint = [page](QPainter& painter) { page->paint(painter); };
  return drawing;
}

}  // namespace mien
