#include "ArrowShape.h"

#include <algorithm>
#include <cmath>

#include "FigureTheme.h"

namespace mien {

namespace {

constexpr double headLength = 1.15;      // mm
constexpr double shortHeadShare = 0.45;  // of an arrow too short for that
constexpr double headWidth = 0.8;        // of the head's length
constexpr double shaftWidth = 0.26;      // of the head's length

}  // namespace

QPolygonF arrowShape(const QPointF& tail, const QPointF& tip) {
  const QPointF along = tip - tail;
  const double length = std::hypot(along.x(), along.y());
  if (!(length > 0.0)) return {};
  const double head = std::min(headLength * figureUnitsPerMillimetre, shortHeadShare * length);
  const QPointF unit = along / length, aside(-unit.y(), unit.x());
  const QPointF neck = tip - head * unit, shaft = 0.5 * shaftWidth * head * aside,
                barb = 0.5 * headWidth * head * aside;
  return QPolygonF() << tail + shaft << neck + shaft << neck + barb << tip << neck - barb << neck - shaft
                     << tail - shaft;
}

}  // namespace mien
