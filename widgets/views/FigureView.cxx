#include "FigureView.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "LineClip.h"
#include "OwnKeys.h"
#include "ScreenFigure.h"
#include "TextLines.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr double unitsPerPixel = figureUnitsPerPixel;
constexpr double handle = 5.0;     // pixels, of a triangle between the axis and its numbers
constexpr double nameDepth = 9.0;  // pixels below the top of the plot
constexpr double markerPoints = 7.0;
constexpr int veil = 170;  // of 255, over what does not count
constexpr double wheelNotch = 120.0, notchZoom = 1.25;
constexpr int pageSteps = 5, allSteps = 1000;

double valueAt(const AxisScale& scale, double fraction) {
  const double t = std::clamp(fraction, 0.0, 1.0);
  if (scale.logarithmic()) return scale.begin() * std::pow(scale.end() / scale.begin(), t);
  return scale.begin() + t * (scale.end() - scale.begin());
}

}  // namespace

FigureView::FigureView(const QString& objectName, Marker marker, QWidget* parent) : QWidget(parent), marker_(marker) {
  setObjectName(objectName);
  setProperty(ownKeys, QStringList{tr("Arrow keys: the value before, the next one"),
                                   tr("Page up, Page down: five values on, five back"),
                                   tr("Home, End: the first value, the last")});
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

FigureView::~FigureView() = default;

void FigureView::setFigure(const Figure& figure) {
  figure_ = figure;
  layOut();
}

void FigureView::setHint(const QString& hint) {
  hint_ = hint;
  update();
}

void FigureView::setMarked(std::optional<double> x) {
  marked_ = x;
  update();
}

void FigureView::setMarkerName(const QString& name) {
  markerName_ = name;
  update();
}

void FigureView::setBand(std::optional<std::pair<double, double>> band) {
  band_ = band;
  update();
}

void FigureView::layOut() {
  painter_.reset();
  picture_ = QPixmap();
  if (!figure_.panels.empty())
    painter_ = std::make_unique<FigurePainter>(figure_, screenTheme(), width() * millimetresPerPixel,
                                               height() * millimetresPerPixel);
  update();
}

QPointF FigureView::pixelOf(int panel, double x, double y) const {
  return painter_ ? painter_->panels().at(panel).position(x, y) / unitsPerPixel : QPointF();
}

void FigureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Theme::current().panel);
  if (!painter_) {
    painter.setPen(Theme::current().faintText);
    painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, hint_);
    return;
  }
  paintFigure(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(1.0 / unitsPerPixel, 1.0 / unitsPerPixel);
  for (const ChartPainter& panel : painter_->panels()) {
    if (band_) paintBand(painter, panel);
    if (marked_) paintMarker(painter, panel);
  }
}

void FigureView::paintFigure(QPainter& painter) {
  if (picture_.isNull()) {
    picture_ = QPixmap(size() * devicePixelRatioF());
    picture_.setDevicePixelRatio(devicePixelRatioF());
    picture_.fill(Theme::current().panel);
    QPainter once(&picture_);
    once.setRenderHint(QPainter::Antialiasing);
    once.scale(1.0 / unitsPerPixel, 1.0 / unitsPerPixel);
    painter_->paint(once);
  }
  painter.drawPixmap(0, 0, picture_);
}

void FigureView::paintBand(QPainter& painter, const ChartPainter& panel) const {
  const QRectF& plot = panel.plot();
  const auto at = [&](double x) { return std::clamp(panel.position(x, 1.0).x(), plot.left(), plot.right()); };
  const double left = at(band_->first), right = at(band_->second);
  QColor color = Theme::current().panel;
  color.setAlpha(veil);
  painter.fillRect(QRectF(QPointF(plot.left() + 1.0, plot.top()), QPointF(left, plot.bottom() - 1.0)), color);
  painter.fillRect(QRectF(QPointF(right, plot.top()), QPointF(plot.right(), plot.bottom() - 1.0)), color);
  painter.setPen(QPen(Theme::current().accent, unitsPerPixel));
  for (double x : {left, right}) painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
}

void FigureView::paintMarker(QPainter& painter, const ChartPainter& panel) const {
  const QRectF& plot = panel.plot();
  QColor color = Theme::current().accent;
  if (marker_ == Marker::Band) {
    color.setAlpha(hasFocus() ? 70 : 45);
    const double left = panel.position(*marked_ - 0.5, 0).x(), right = panel.position(*marked_ + 0.5, 0).x();
    painter.fillRect(QRectF(left, plot.top(), right - left, plot.height()), color);
    return;
  }
  const double x = panel.position(*marked_, 1.0).x();
  if (x < plot.left() - 1.0 || x > plot.right() + 1.0) return;
  color = Theme::current().text;  // neutral, unlike the lines of the data
  painter.setPen(QPen(color, (hasFocus() ? 2.0 : 1.4) * unitsPerPixel));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  const double half = handle * unitsPerPixel;
  const QPointF tip(x, plot.bottom());
  painter.setBrush(color);
  painter.setPen(Qt::NoPen);
  painter.drawPolygon(QPolygonF({tip, tip + QPointF(half, 1.2 * half), tip + QPointF(-half, 1.2 * half)}));
  painter.setPen(color);
  paintMarkerName(painter, panel, QPointF(x, plot.top() + nameDepth * unitsPerPixel));
}

/// How many lines of the panel run through a place.
int FigureView::linesIn(const ChartPainter& panel, const QRectF& place) const {
  const size_t index = &panel - painter_->panels().data();
  const auto& series = figure_.panels[index].series;
  return std::count_if(series.begin(), series.end(), [&](const ChartSeries& one) {
    QPolygonF line;
    for (size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i)
      if (std::isfinite(one.y[i])) line << panel.position(one.x[i], one.y[i]);
    return !clippedLine(line, place).empty();
  });
}

/// On the side of the line where fewer lines are, or that has more room, on a ground of its own: lines run below it.
void FigureView::paintMarkerName(QPainter& painter, const ChartPainter& panel, const QPointF& beside) const {
  if (markerName_.isEmpty()) return;
  const QFont font = figureFont(markerPoints);
  const double gap = 2.0 * handle * unitsPerPixel, width = textWidth(font, markerName_), height = lineHeight(font);
  const QRectF right(beside.x() + gap, beside.y() - 0.5 * height, width, height);
  const QRectF left = right.translated(-2.0 * gap - width, 0.0);
  const bool isLeftRoomier = beside.x() >= panel.plot().center().x();
  QRectF place = isLeftRoomier ? left : right;
  const QRectF other = isLeftRoomier ? right : left;
  if (panel.plot().contains(other) && linesIn(panel, other) < linesIn(panel, place)) place = other;
  painter.fillRect(place, Theme::current().panel);
  painter.setFont(font);
  painter.drawText(place.bottomLeft() - QPointF(0.0, 0.2 * height), markerName_);
}

void FigureView::resizeEvent(QResizeEvent*) {
  layOut();
}

void FigureView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) layOut();
  QWidget::changeEvent(event);
}

/// The panel is that above or below the pointer; beyond the ends of an axis its ends are picked. There must be one.
double FigureView::valueUnder(const QPointF& pixel) const {
  const QPointF at = pixel * unitsPerPixel;
  const ChartPainter* nearest = nullptr;
  double least = 1e300;
  for (const ChartPainter& panel : painter_->panels()) {
    const QRectF& plot = panel.plot();
    const double dx = std::max({plot.left() - at.x(), at.x() - plot.right(), 0.0});
    const double dy = std::max({plot.top() - at.y(), at.y() - plot.bottom(), 0.0});
    if (dx + dy >= least) continue;
    least = dx + dy;
    nearest = &panel;
  }
  return valueAt(nearest->xScale(), (at.x() - nearest->plot().left()) / nearest->plot().width());
}

void FigureView::pickAt(const QPointF& pixel) {
  const double value = valueUnder(pixel);
  bandStart_ ? emit bandDragged(*bandStart_, value) : emit picked(value);
}

void FigureView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !painter_) return;
  bandStart_.reset();
  if (event->modifiers() & Qt::ShiftModifier)
    bandStart_ = valueUnder(event->pos());
  else
    pickAt(event->pos());
}

void FigureView::mouseMoveEvent(QMouseEvent* event) {
  if (painter_ && event->buttons() & Qt::LeftButton) pickAt(event->pos());
}

void FigureView::wheelEvent(QWheelEvent* event) {
  if (!painter_) return event->ignore();
  emit zoomed(valueUnder(event->position()), std::pow(notchZoom, -event->angleDelta().y() / wheelNotch));
}

void FigureView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Down:
      return emit stepped(-1);
    case Qt::Key_Right:
    case Qt::Key_Up:
      return emit stepped(1);
    case Qt::Key_PageDown:
      return emit stepped(-pageSteps);
    case Qt::Key_PageUp:
      return emit stepped(pageSteps);
    case Qt::Key_Home:
      return emit stepped(-allSteps);
    case Qt::Key_End:
      return emit stepped(allSteps);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace mien
