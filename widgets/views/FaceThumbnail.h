#pragma once

#include <QColor>
#include <QImage>
#include <QSize>

#include "FaceSample.h"

namespace mien {

/// What small pictures of faces share, so that they can be compared: place, scale and colours.
struct ThumbnailStyle {
  QSize size;
  Eigen::Vector2d low, high;  ///< of the part that is shown, in the plane through `middle`, mm
  QColor skin;
  Eigen::Vector3d middle;  ///< looked at, mm
  double distance;         ///< from there, mm

  /// The frame around the curves of a face, seen from the front, with room above the head and beside it.
  void frame(const FaceCurves& face);

  /// Where a point is seen in the plane through `middle`: what is nearer looks larger, as in the views.
  Eigen::Vector2d seen(const Eigen::Vector3d& point) const;
};

/// A small picture of a face from the front on a transparent ground, drawn without a graphics card, so that any thread
/// can.
QImage faceThumbnail(const FaceSample& sample, const ThumbnailStyle& style);

}  // namespace mien
