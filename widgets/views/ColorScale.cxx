#include "ColorScale.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QLinearGradient>
#include <QPainter>

#include "CurveView.h"
#include "FaceModel.h"
#include "Theme.h"

namespace mien {

namespace {

constexpr int side = 12, scaleGap = 8, barHeight = 9, above = 5, tick = 3, below = 3;  // pixels
constexpr double point = 8.0;  // pixels, length of the pointed end

QString lengthText(double millimetres) {
  return ColorScale::tr("most %1 mm").arg(millimetres, 0, 'f', 1);
}

}  // namespace

ColorScale::ColorScale(FaceModel* model, QWidget* parent) : QWidget(parent), model_(model) {
  setObjectName("curveScale");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setToolTip(
      tr("How far the curves have moved from the neutral face; the colours mean the same lengths at all times. "
         "A pointed end: something has moved further than the last colour"));
  connect(model_, &FaceModel::updated, this, &ColorScale::follow);
  follow();
}

bool ColorScale::isExceeded() const {
  return most_ > CurveView::fullColorLength;
}

QSize ColorScale::sizeHint() const {
  return {300, above + barHeight + tick + below + fontMetrics().height()};
}

QSize ColorScale::minimumSizeHint() const {
  return {120, sizeHint().height()};
}

/// Without FAPs to move it, a face has no displacements.
void ColorScale::follow() {
  auto* curves = vtkPolyData::SafeDownCast(model_->pipeline().shownCurves()->GetOutputDataObject(0));
  vtkDataArray* moved = curves ? curves->GetPointData()->GetArray("Displacement") : nullptr;
  const double most = moved ? moved->GetMaxNorm() : 0.0;
  if (most == most_) return;
  most_ = most;
  update();
}

void ColorScale::paintBar(QPainter& painter, const QRectF& bar) const {
  const Theme& theme = Theme::current();
  QLinearGradient colors(bar.topLeft(), bar.topRight());
  colors.setColorAt(0.0, theme.curve);
  colors.setColorAt(1.0, theme.curveMoved);
  QPolygonF shape;
  shape << bar.topLeft() << bar.topRight();
  if (isExceeded()) shape << QPointF(bar.right() + point, bar.center().y());
  shape << bar.bottomRight() << bar.bottomLeft();
  painter.setPen(QPen(theme.line, 1.0));
  painter.setBrush(colors);
  painter.drawPolygon(shape);
}

void ColorScale::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::current();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), theme.viewBottom);
  const QFontMetrics metrics = fontMetrics();
  const QString title = tr("moved by"), most = lengthText(most_);
  const int before = side + metrics.horizontalAdvance(title) + scaleGap;
  const int after = side + metrics.horizontalAdvance(lengthText(888.8)) + scaleGap + static_cast<int>(point);
  const QRectF bar(before, above, std::max(20, width() - before - after), barHeight);
  paintBar(painter, bar);
  const double base = above + barHeight / 2.0 + metrics.ascent() / 2.0 - 1.0;
  painter.setPen(theme.text);
  painter.drawText(QPointF(side, base), title);
  painter.setPen(isExceeded() ? theme.curveMoved : theme.text);
  painter.drawText(QPointF(width() - side - metrics.horizontalAdvance(most), base), most);
  painter.setPen(theme.text);
  for (double share : {0.0, 0.5, 1.0}) {
    const double x = bar.left() + share * bar.width();
    const QString text = QString::number(share * CurveView::fullColorLength) + (share == 1.0 ? tr(" mm") : QString());
    const double left = x - metrics.horizontalAdvance(QString::number(share * CurveView::fullColorLength)) / 2.0;
    painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + tick));
    painter.drawText(QPointF(left, bar.bottom() + tick + metrics.ascent()), text);
  }
}

}  // namespace mien
