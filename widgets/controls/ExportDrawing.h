#pragma once

#include <QSizeF>
#include <functional>
#include <string>

#include "Figure.h"

class QPainter;

namespace mien {

/// A figure ready to be written: as large as a page's text is wide, in the colours of paper.
struct ExportDrawing {
  static constexpr double width = 170.0;  ///< mm, the text width of an A4 page

  ExportDrawing() = default;

  /// A figure of charts; nothing without panels.
  ExportDrawing(const Figure& figure);

  QSizeF size;                           ///< figure units
  std::function<void(QPainter&)> paint;  ///< empty: there is nothing to write yet
  std::string title;                     ///< kept in the file
  std::string description;               ///< the same, beside the state of the face
};

}  // namespace mien
