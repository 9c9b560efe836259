#include "VectorStyle.h"

namespace mien {

namespace {

constexpr double equalArrow = 2.5;  // mm

}  // namespace

VectorStyle::VectorStyle(const MotionVectorOptions& options)
    : length(options.length),
      color(options.color),
      family(QString::fromStdString(options.font)),
      colorMap(options.colorMap),
      asRow(options.asRow) {
  const FigureTheme* const known = FigureTheme::find(options.theme);
  if (colorMap.empty()) colorMap = color == MotionVectorOptions::Color::Towards ? "coolwarm" : "viridis";
  theme = known ? *known : FigureTheme::all().front();
  if (options.background.isValid()) theme.background = options.background;
}

QFont VectorStyle::font(double points, bool bold) const {
  QFont font = figureFont(points, bold);
  if (!family.isEmpty()) font.setFamily(family);
  return font;
}

QPointF VectorStyle::arrow(const PictureArrow& arrow) const {
  using Length = MotionVectorOptions::Length;
  const double seen = arrow.vector.norm();
  if (!(seen > 0.0) || (length == Length::Equal && seen < leastShown)) return {};
  const double factor = length == Length::Equal     ? equalArrow / seen
                        : length == Length::InSpace ? arrow.magnitude / seen / scale
                                                    : 1.0 / scale;
  return factor * figureUnitsPerMillimetre * QPointF(arrow.vector.x(), -arrow.vector.y());
}

double VectorStyle::coloredValue(const PictureArrow& arrow) const {
  return color == MotionVectorOptions::Color::Towards ? arrow.towards : arrow.magnitude;
}

QColor VectorStyle::colorOf(const PictureArrow& arrow) const {
  if (color == MotionVectorOptions::Color::None) return theme.text;
  return VectorColors(colorMap, theme, rangeBegin, rangeEnd).at(coloredValue(arrow));
}

}  // namespace mien
