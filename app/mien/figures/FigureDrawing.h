#pragma once

#include <QSizeF>
#include <functional>

class QPainter;

namespace mien {

/// A figure that is ready to be written: its size in figure units, and how it is painted.
struct FigureDrawing {
  QSizeF size;
  std::function<void(QPainter&)> paint;
};

}  // namespace mien
