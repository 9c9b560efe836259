#pragma once

#include <QRectF>

#include "AxisScale.h"
#include "Chart.h"
#include "FigureTheme.h"

class QPainter;

namespace mien {

/// Where series of a chart break down: the marker of each stands on the plot's upper edge, on a stem at its x that
/// goes down to the axis where it is alone. Neighbours stand at different heights, so that none hides another.
class BreakdownFlags {
 public:
  BreakdownFlags(const Chart& chart, const FigureTheme& theme) : chart_(chart), theme_(theme) {}

  /// The room above the plot, in figure units; 0 where nothing breaks down.
  static double height(const Chart& chart);

  void paint(QPainter& painter, const QRectF& plot, const AxisScale& x) const;

 private:
  const Chart& chart_;
  const FigureTheme& theme_;
};

}  // namespace mien
