#include "LineClip.h"

#include <algorithm>

namespace mien {

namespace {

/// Cuts [t0, t1] to where start + t * move >= 0; false when nothing is left [Liang and Barsky 1984].
bool cut(double start, double move, double& t0, double& t1) {
  if (move == 0.0) return start >= 0.0;
  const double t = -start / move;
  if (move > 0.0)
    t0 = std::max(t0, t);
  else
    t1 = std::min(t1, t);
  return t0 <= t1;
}

bool clipSegment(const QPointF& a, const QPointF& b, const QRectF& r, double& t0, double& t1) {
  const QPointF d = b - a;
  return cut(a.x() - r.left(), d.x(), t0, t1) && cut(r.right() - a.x(), -d.x(), t0, t1) &&
         cut(a.y() - r.top(), d.y(), t0, t1) && cut(r.bottom() - a.y(), -d.y(), t0, t1);
}

}  // namespace

std::vector<QPolygonF> clippedLine(const QPolygonF& line, const QRectF& rectangle) {
  std::vector<QPolygonF> parts;
  bool connected = false;  // whether the last part ends where this segment begins
  for (int i = 0; i + 1 < line.size(); ++i) {
    double t0 = 0.0, t1 = 1.0;
    const QPointF a = line[i], d = line[i + 1] - line[i];
    if (!clipSegment(a, line[i + 1], rectangle, t0, t1)) {
      connected = false;
      continue;
    }
    if (!connected || t0 > 0.0) parts.push_back(QPolygonF() << a + t0 * d);
    parts.back() << (t1 < 1.0 ? a + t1 * d : line[i + 1]);
    connected = t1 == 1.0;
  }
  return parts;
}

}  // namespace mien
