#include "PlaneAxes.h"

#include <algorithm>
#include <cmath>

#include "AxisScale.h"

namespace mien {

namespace {

constexpr double tick = 0.7, numbersRoom = 5.5, titlePlace = 5.4, unitRoom = 7.0, titleRoom = 3.0;  // mm
constexpr double paddingShare = 0.04;   // of the content, on every side
constexpr double axisNumberSize = 6.0;  // pt
constexpr double stepRounding = 1e-9;   // of a step

PlaneStroke axisStroke() {
  PlaneStroke stroke;
  stroke.width = 0.4;
  return stroke;
}

/// The multiples of the step from `from` to `to`.
std::vector<double> multiples(double from, double to, double step) {
  std::vector<double> values;
  for (double i = std::ceil(from / step - stepRounding); i <= std::floor(to / step + stepRounding); ++i)
    values.push_back(i * step);
  return values;
}

PlaneDrawing::Label label(const QPointF& at, const QString& text, int alignment) {
  PlaneDrawing::Label label;
  label.at = at;
  label.text = text;
  label.size = axisNumberSize;
  label.alignment = alignment;
  return label;
}

}  // namespace

QRectF addPlaneAxes(PlaneDrawing& drawing, const QRectF& content, double step, const QString& unit, double width) {
  const double padX = paddingShare * content.width(), padY = paddingShare * content.height();
  const QRectF range = content.adjusted(-padX, -padY, padX, padY);
  const double perMillimetre = range.width() / std::max(width - numbersRoom, 1.0);
  const double left = range.left(), bottom = range.top(), length = tick * perMillimetre;  // y is up
  const auto number = [&](double value) { return QString::fromStdString(tickText(value, step)); };
  drawing.lines.push_back({segment({left, bottom}, {range.right(), bottom}), axisStroke()});
  drawing.lines.push_back({segment({left, bottom}, {left, range.bottom()}), axisStroke()});
  for (const double x : multiples(left, range.right(), step)) {
    drawing.lines.push_back({segment({x, bottom}, {x, bottom - length}), axisStroke()});
    drawing.labels.push_back(label({x, bottom - length}, number(x), Qt::AlignHCenter | Qt::AlignTop));
  }
  for (const double y : multiples(bottom, range.bottom(), step)) {
    drawing.lines.push_back({segment({left, y}, {left - length, y}), axisStroke()});
    drawing.labels.push_back(label({left - length, y}, number(y), Qt::AlignRight | Qt::AlignVCenter));
  }
  const QPointF below(range.center().x(), bottom - titlePlace * perMillimetre);
  const QPointF above(left - numbersRoom * perMillimetre, range.bottom() + 0.5 * titleRoom * perMillimetre);
  drawing.labels.push_back(label(below, "x (" + unit + ")", Qt::AlignCenter));
  drawing.labels.push_back(label(above, "y (" + unit + ")", Qt::AlignLeft | Qt::AlignVCenter));
  return range.adjusted(-numbersRoom * perMillimetre, -unitRoom * perMillimetre, 0.0, titleRoom * perMillimetre);
}

}  // namespace mien
