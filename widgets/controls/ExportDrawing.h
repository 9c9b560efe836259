#pragma once

#include <QSizeF>
#include <functional>
#include <string>

#include "ExportOptions.h"
#include "Figure.h"

class QPainter;

namespace mien {

/// A figure ready to be written.
struct ExportDrawing {
  static constexpr double pageWidth = 170.0;  ///< mm, the text width of an A4 page

  ExportDrawing() = default;

  /// A figure of charts, as wide as a page's text unless the options say otherwise; nothing without panels.
  ExportDrawing(const Figure& figure, const ExportOptions& options);

  QSizeF size;                           ///< figure units
  std::function<void(QPainter&)> paint;  ///< empty: there is nothing to write yet
  std::string title;                     ///< kept in the file
  std::string description;               ///< the same, beside the state of the face
};

}  // namespace mien
