#pragma once

#include <QPen>
#include <QPointF>

#include "FigureTheme.h"

class QPainter;

namespace mien {

/// How one of several series is drawn: colour, dashes and marker each tell it from the others.
class SeriesStyle {
 public:
  static constexpr int count = 6;

  SeriesStyle(const FigureTheme& theme, int index);

  const QColor& color() const { return color_; }

  /// @param share  of the width of lines
  QPen linePen(double share = 1.0) const;

  void drawMarker(QPainter& painter, const QPointF& center) const;

 private:
  QColor color_, background_;
  int index_;
  double width_;  ///< of lines, in figure units
};

}  // namespace mien
