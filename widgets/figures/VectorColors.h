#pragma once

#include <QColor>
#include <array>
#include <string>

#include "ColorTable.h"
#include "FigureTheme.h"

namespace mien {

/// Colours of values between two ends. Of a map only the part is used that stands out from the theme's background;
/// a diverging one is used whole, darkened towards its middle on light backgrounds.
class VectorColors {
 public:
  /// @param map  of ColorTable, with "_r" turned around; one that is unknown counts as viridis
  VectorColors(const std::string& map, const FigureTheme& theme, double begin, double end);

  static bool isKnown(const std::string& map);

  double begin() const { return begin_; }
  double end() const { return end_; }

  /// Values beyond the ends have the ends' colours.
  QColor at(double value) const;

 private:
  const ColorTable* table_;
  double begin_, end_;
  double shade_ = 1.0;               ///< factor on the middle's colour
  double first_ = 0.0, last_ = 1.0;  ///< places in the table of the two ends
};

}  // namespace mien
