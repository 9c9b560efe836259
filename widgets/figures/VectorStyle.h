#pragma once

#include <QFont>
#include <QPointF>
#include <QString>

#include "FigureTheme.h"
#include "MotionVectorOptions.h"
#include "VectorColors.h"

namespace mien {

/// What all panels of a motion vector figure and its key share: one scale, one range of colours, theme and font.
struct VectorStyle {
  /// With the ends of the colours and the scale still to be chosen when the options leave that open.
  explicit VectorStyle(const MotionVectorOptions& options);

  MotionVectorOptions::Length length;
  MotionVectorOptions::Color color;
  FigureTheme theme;
  QString family;
  std::string colorMap;
  double scale = 1.0;                       ///< mm of motion per mm of arrow
  bool asRow = false;                       ///< headings in the middle
  double leastShown = 0.0;                  ///< mm; what moves less has no arrow of equal length
  double rangeBegin = 0.0, rangeEnd = 1.0;  ///< mm
  bool lacksTowards = false;                ///< whether the colours have nothing to tell: nothing moves to the viewer

  QFont font(double points, bool bold = false) const;

  /// From tail to tip in figure units, y downwards.
  QPointF arrow(const PictureArrow& arrow) const;

  /// What the arrow's colour tells, mm.
  double coloredValue(const PictureArrow& arrow) const;

  QColor colorOf(const PictureArrow& arrow) const;
};

}  // namespace mien
