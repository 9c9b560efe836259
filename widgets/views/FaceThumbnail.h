#pragma once

#include <QColor>
#include <QImage>
#include <QSize>

#include "FaceSample.h"

namespace mien {

/// What small pictures of faces share, so that they can be compared: place, scale and colours.
struct ThumbnailStyle {
  QSize size;
  Eigen::Vector2d low, high;  ///< x and y of the part that is shown, mm
  QColor skin;

  /// The frame around the curves of a face, seen from the front.
  void frame(const FaceCurves& face);
};

/// A small picture of a face from the front on a transparent ground, drawn without a graphics card, so that any thread
/// can.
QImage faceThumbnail(const FaceSample& sample, const ThumbnailStyle& style);

}  // namespace mien
