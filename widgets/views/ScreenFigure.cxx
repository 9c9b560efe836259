#include "ScreenFigure.h"

#include "Theme.h"

namespace mien {

FigureTheme screenTheme() {
  const Theme& theme = Theme::current();
  FigureTheme colors = *FigureTheme::find(theme.kind == Theme::Kind::Dark ? "dark" : "light");
  colors.background = theme.panel;
  return colors;
}

}  // namespace mien
