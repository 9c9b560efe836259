#pragma once

#include <QRectF>
#include <optional>

#include "FigureTheme.h"
#include "PlaneDrawing.h"
#include "Plate.h"

class QPainter;

namespace mien {

/// Paints a plane drawing into a rectangle, with one scale for x and y; widths of lines and type keep their size.
class PlaneDrawingPainter {
 public:
  enum class Margin { Around, None };

  /// @param shown  what part of the plane fills the rectangle; none: all of the drawing
  /// @param margin  a little air around it, or none, over a picture that fills the rectangle
  PlaneDrawingPainter(const PlaneDrawing& drawing, const QRectF& place, const std::optional<QRectF>& shown = {},
                      Margin margin = Margin::Around);

  void paint(QPainter& painter, const FigureTheme& theme) const;

  QPointF position(const QPointF& plane) const;
  double scale() const { return scale_; }  ///< figure units for one unit of the drawing

 private:
  void paintLine(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Line& line) const;
  void paintMark(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Mark& mark) const;
  void paintLabel(QPainter& painter, const FigureTheme& theme, const PlaneDrawing::Label& label, bool halo) const;

  const PlaneDrawing& drawing_;
  double scale_ = 1.0;
  QPointF origin_;  ///< where the plane's origin is painted
};

/// A panel that holds the drawing, as high as the drawing asks for.
///
/// @param shown  the part of the plane that is seen, the same for drawings that are to be compared; none: all of it
PlatePanel drawingPanel(const std::string& heading, const PlaneDrawing& drawing,
                        const std::optional<QRectF>& shown = {});

}  // namespace mien
