#pragma once

#include <QSizeF>
#include <functional>
#include <string>

class QPainter;

namespace mien {

/// A figure that is ready to be written: its size in figure units, how it is painted, and its words, whether they are
/// painted or not.
struct FigureDrawing {
  QSizeF size;
  std::function<void(QPainter&)> paint;
  std::string caption, note;
};

}  // namespace mien
