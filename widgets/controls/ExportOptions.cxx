#include "ExportOptions.h"

namespace mien {

FigureTheme ExportOptions::figureTheme() const {
  const FigureTheme* found = FigureTheme::find(theme);
  FigureTheme drawn = found ? *found : FigureTheme::all().front();
  if (transparent) drawn.background.setAlpha(0);
  return drawn;
}

}  // namespace mien
