#pragma once

#include <QRectF>
#include <QStringList>

#include "VectorStyle.h"

class QPainter;

namespace mien {

/// The key of a motion vector figure: a reference arrow with its scale, and a colour bar in mm beside it, or below it
/// in a narrow key.
class VectorKeyPainter {
 public:
  /// @param reference  motion of the reference arrow, mm; 0: none
  /// @param width      of the key, figure units
  /// @param beyond     whether values lie below, above the ends of the colours: the bar gets a point there
  VectorKeyPainter(const VectorStyle& style, double reference, double width, std::pair<bool, bool> beyond);

  double height() const;
  QSizeF size() const { return {width_, height()}; }
  void paint(QPainter& painter, const QPointF& topLeft) const;

 private:
  bool hasBar() const;
  bool isStacked() const;
  double referenceHeight() const;
  double barLeft() const;
  void paintReference(QPainter& painter, const QPointF& topLeft) const;
  void paintBar(QPainter& painter, const QRectF& bar) const;
  void paintTicks(QPainter& painter, const QRectF& bar) const;
  QPolygonF barShape(const QRectF& bar) const;
  QString title() const;

  VectorStyle style_;
  double reference_, width_;
  std::pair<bool, bool> beyond_;
  QStringList scaleLines_, titleLines_;
};

}  // namespace mien
