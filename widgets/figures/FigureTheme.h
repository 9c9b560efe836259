#pragma once

#include <QColor>
#include <QFont>
#include <string>
#include <vector>

namespace mien {

/// Figures are drawn in hundredths of a millimetre, whatever the file's format.
constexpr double figureUnitsPerMillimetre = 100.0;

constexpr double figureUnits(double millimetres) {
  return millimetres * figureUnitsPerMillimetre;
}

/// A length of typography in units of figures: 1 pt is 1/72 inch.
constexpr double figureUnitsFromPoints(double points) {
  return points * 25.4 / 72.0 * figureUnitsPerMillimetre;
}

/// Colours, fonts and line widths of figures.
///
/// The colours are those of Okabe and Ito, which all common kinds of colour blindness can tell apart.
struct FigureTheme {
  std::string name;
  QColor background;  ///< invalid: none, the page's own
  QColor text, axis, grid;
  std::vector<QColor> series;
  double lineWidth = 1.0;  ///< pt
  double axisWidth = 0.5;  ///< pt

  /// This theme's own for a series colour of the light theme; other colours, and those it has itself, as they are.
  QColor own(const QColor& color) const;

  static const std::vector<FigureTheme>& all();

  /// The theme of that name, or nullptr.
  static const FigureTheme* find(const std::string& name);
};

/// The family of all figures drawn from now on; it must be installed. Empty, the default: DejaVu Sans. To be set before
/// anything is laid out.
void setFigureFontFamily(const QString& family);

/// The font of figures in a size in pt.
QFont figureFont(double points, bool bold = false);

}  // namespace mien
