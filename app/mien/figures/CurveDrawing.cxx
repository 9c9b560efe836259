#include "CurveDrawing.h"

#include <algorithm>
#include <cmath>

#include "FaceLayout.h"
#include "LabelSpread.h"

namespace mien {

namespace {

constexpr int pointsPerSample = 6;
constexpr double leaderBend = 3.0, leaderLength = 7.0;  // mm of the face, beyond the curves
constexpr double bracketDepth = 2.0, bracketGap = 0.8;  // mm; the gap lies between a patch and the next
constexpr double curveNameSize = 6.0;                   // pt
const QColor leaderColor("#9a9a9a");

QPointF seenFromFront(const Eigen::Vector3d& point) {
  return {point.x(), point.y()};
}

PlaneStroke leaderStroke() {
  PlaneStroke stroke;
  stroke.color = leaderColor;
  stroke.width = 0.3;
  return stroke;
}

}  // namespace

CurveDrawing::CurveDrawing(const ClosedCurves& curves, double from, double to)
    : curves_(curves), from_(from), to_(to) {}

QPolygonF CurveDrawing::line(int curve) const {
  const double share = (to_ - from_) / (2.0 * M_PI);
  const int steps = std::max(2, static_cast<int>(std::lround(pointsPerSample * curves_.pointsPerCurve * share)));
  QPolygonF points;
  for (int i = 0; i <= steps; ++i) points << seenFromFront(curves_.at(curve, from_ + (to_ - from_) * i / steps));
  return points;
}

QPolygonF CurveDrawing::samples(int curve) const {
  QPolygonF points;
  for (int j = 0; j < curves_.pointsPerCurve; ++j) {
    const double v = 2.0 * M_PI * j / curves_.pointsPerCurve;
    if (v >= from_ - 1e-9 && v <= to_ + 1e-9) points << seenFromFront(curves_.curve(curve).row(j).transpose());
  }
  return points;
}

void CurveDrawing::addLines(PlaneDrawing& drawing, const std::function<PlaneStroke(int)>& stroke) const {
  for (int curve = 0; curve < curves_.count; ++curve) {
    const PlaneStroke pen = stroke(curve);
    if (pen.width > 0.0) drawing.lines.push_back({line(curve), pen});
  }
}

QRectF CurveDrawing::bounds() const {
  QPolygonF all;
  for (int curve = 0; curve < curves_.count; ++curve) all += line(curve);
  return all.boundingRect();
}

void CurveDrawing::addNames(PlaneDrawing& drawing, const std::vector<int>& curves, bool right, double gap) const {
  std::vector<QPointF> ends;
  std::vector<double> wanted;
  for (int curve : curves) {
    ends.push_back(right ? line(curve).last() : line(curve).first());
    wanted.push_back(-ends.back().y());
  }
  const std::vector<double> places = spreadLabels(wanted, gap);
  const double side = right ? 1.0 : -1.0, edge = right ? bounds().right() : bounds().left();
  for (size_t i = 0; i < curves.size(); ++i) {
    const QPointF at(edge + side * leaderLength, -places[i]);
    const QPointF bend(edge + side * leaderBend, ends[i].y());
    drawing.lines.push_back({QPolygonF({ends[i], bend, at}), leaderStroke()});
    drawing.labels.push_back({at, QString::fromStdString(FaceLayout::curveName(curves[i])), curveNameSize,
                              int((right ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter)});
  }
}

void CurveDrawing::addPatchNames(PlaneDrawing& drawing, double distance) const {
  const double x = bounds().left() - distance;
  PlaneStroke stroke = leaderStroke();
  stroke.width = 0.6;
  for (int patch = 0; patch < FaceLayout::patchCount; ++patch) {
    const int first = FaceLayout::firstCurve[patch];
    const double top = line(first).first().y() - bracketGap, bottom = line(first + 3).first().y() + bracketGap;
    const QPolygonF bracket({{x + bracketDepth, top}, {x, top}, {x, bottom}, {x + bracketDepth, bottom}});
    drawing.lines.push_back({bracket, stroke});
    drawing.labels.push_back({QPointF(x, 0.5 * (top + bottom)), QString("P%1").arg(patch), curveNameSize,
                              Qt::AlignRight | Qt::AlignVCenter});
  }
}

}  // namespace mien
