#pragma once

#include "FigureTheme.h"

namespace mien {

/// Figures on the screen: type of 7 pt is as large as the interface's own.
constexpr double millimetresPerPixel = 25.4 / 96.0 / 1.25;
constexpr double figureUnitsPerPixel = millimetresPerPixel * figureUnitsPerMillimetre;

/// The colours of figures on the screen, which follow the application's theme.
FigureTheme screenTheme();

}  // namespace mien
