#pragma once

#include <QRectF>
#include <functional>
#include <string>
#include <vector>

#include "FigureTheme.h"

class QPainter;

namespace mien {

/// One panel of a plate: whatever can be painted into a rectangle.
struct PlatePanel {
  std::string heading;  ///< above the panel, behind its label; may be empty
  int span = 1;         ///< columns of the plate that it takes
  double shape = 1.0;   ///< height over width of what is painted

  /// Paints into the rectangle, in figure units; the theme is the plate's.
  std::function<void(QPainter&, const QRectF&, const FigureTheme&)> paint;

  std::string label = {};  ///< in place of the plate's own (a), (b) ..; empty: that
};

/// A figure of panels of any kind (drawings, pictures, charts, tables) in a grid, labelled (a), (b) ..
struct Plate {
  std::string title;  ///< above the panels; may be empty
  std::vector<PlatePanel> panels;
  int columns = 2;
  std::string caption;  ///< below: what is seen
  std::string note;     ///< below, smaller: what the figure was made with
};

}  // namespace mien
