#include "FloatingBars.h"

#include <QEvent>
#include <QLayout>
#include <QWidget>
#include <algorithm>

#include "RenderView.h"

namespace mien {

namespace {

constexpr int mostWidth = 1100;   // pixels, so that what it lies over is not seen at its ends
constexpr int edge = 8, gap = 6;  // pixels to the edge of the area, between bars

int heightOf(const QWidget& bar, int width) {
  return bar.layout()->hasHeightForWidth() ? bar.layout()->totalHeightForWidth(width) : bar.sizeHint().height();
}

}  // namespace

FloatingBars::FloatingBars(QWidget* area, const QList<RenderView*>& views, const QList<QWidget*>& bars, QWidget* parent)
    : QObject(parent), area_(area), parent_(parent), views_(views), bars_(bars) {
  for (QWidget* bar : bars_) {
    const bool isHidden = bar->isHidden();
    bar->setParent(parent);
    bar->setHidden(isHidden);
    bar->installEventFilter(this);
  }
  area->installEventFilter(this);
  for (RenderView* view : views) view->installEventFilter(this);
}

bool FloatingBars::eventFilter(QObject* watched, QEvent* event) {
  const bool isBar = bars_.contains(static_cast<QWidget*>(watched));
  switch (event->type()) {
    case QEvent::Show:
    case QEvent::LayoutRequest:
      place();
      break;
    case QEvent::Hide:
    case QEvent::Move:
    case QEvent::Resize:
      if (!isBar || event->type() == QEvent::Hide) place();
      break;
    default:
      break;
  }
  return QObject::eventFilter(watched, event);
}

void FloatingBars::place() {
  const int left = area_->mapTo(parent_, QPoint()).x();
  const int most = std::min(mostWidth, area_->width() - 2 * edge);
  int bottom = parent_->height();
  for (const RenderView* view : views_)  // not over the key at its foot
    if (view->isVisible()) bottom = std::min(bottom, view->mapTo(parent_, QPoint()).y() + view->freeHeight() - edge);
  for (QWidget* bar : bars_) {
    if (bar->isHidden()) continue;
    const int width = std::min(most, bar->maximumWidth());
    const int height = heightOf(*bar, width);
    bar->setGeometry(left + (area_->width() - width) / 2, std::max(0, bottom - height), width, height);
    bar->raise();
    bottom -= height + gap;
  }
}

}  // namespace mien
