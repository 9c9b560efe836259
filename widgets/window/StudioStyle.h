#pragma once

#include <QProxyStyle>

namespace mien {

/// Fusion, but flat: lists of choices are drawn in the palette's colours without a gradient, and the buttons of docks
/// with icons in the colour of text, in light and dark.
class StudioStyle : public QProxyStyle {
  Q_OBJECT
 public:
  StudioStyle();

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override;
  void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                   const QWidget* widget) const override;
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  QIcon standardIcon(StandardPixmap pixmap, const QStyleOption* option, const QWidget* widget) const override;
};

}  // namespace mien
