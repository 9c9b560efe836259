#pragma once

#include <string>

#include "FigureTheme.h"

namespace mien {

/// How what is shown is written as a figure.
struct ExportOptions {
  double width = 0.0;           ///< mm; 0: what suits the figure
  double dotsPerInch = 300.0;   ///< of pictures
  std::string theme = "light";  ///< of FigureTheme
  bool transparent = false;     ///< whether the page shows through

  /// The theme as it is to be drawn: one that is transparent has a background without opacity, which still says
  /// whether it is light or dark.
  FigureTheme figureTheme() const;
};

}  // namespace mien
