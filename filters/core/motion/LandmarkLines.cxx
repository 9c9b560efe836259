#include "LandmarkLines.h"

#include <algorithm>
#include <iterator>

#include "FaceLayout.h"

namespace mien {

namespace {

constexpr int pointsPerLine = 49;

/// Part of one curve, from one feature point to another.
struct Arc {
  const char* curve;
  const char* from;
  const char* to;
};

constexpr Arc arcs[] = {{"C9", "3.11", "3.7"}, {"C10", "3.11", "3.7"}, {"C9", "3.12", "3.8"}, {"C10", "3.12", "3.8"},
                        {"C6", "4.1", "4.5"},  {"C6", "4.6", "4.2"},   {"C21", "8.4", "8.3"}, {"C23", "8.4", "8.3"}};

/// Half of the nose's outline, downwards: how far out, of the way from the midline to the wing's feature point.
struct WingPlace {
  const char* curve;
  double share;
};

constexpr WingPlace wing[] = {{"C15", 0.80}, {"C16", 0.94}, {"C17", 1.0}, {"C18", 0.80}, {"C18", 0.45}};
constexpr int pointsPerSpan = 8;

/// A point of the Catmull-Rom spline between b and c, t from 0 to 1.
Eigen::RowVector3d between(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c,
                           const Eigen::RowVector3d& d, double t) {
  return 0.5 *
         (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) + t * t * t * (3.0 * b - a - 3.0 * c + d));
}

ClosedCurves::Points smoothed(const ClosedCurves::Points& places) {
  const int last = static_cast<int>(places.rows()) - 1;
  ClosedCurves::Points line(last * pointsPerSpan + 1, 3);
  for (int i = 0; i < line.rows(); ++i) {
    const int span = std::min(i / pointsPerSpan, last - 1);
    line.row(i) = between(places.row(std::max(span - 1, 0)), places.row(span), places.row(span + 1),
                          places.row(std::min(span + 2, last)), static_cast<double>(i) / pointsPerSpan - span);
  }
  return line;
}

/// Down one wing, along the base of the nose and up the other wing.
ClosedCurves::Points noseLine(const FaceCurves& face, double right, double left) {
  const int half = static_cast<int>(std::size(wing));
  ClosedCurves::Points places(2 * half, 3);
  for (int i = 0; i < half; ++i) {
    const int curve = FaceLayout::curveIndex(wing[i].curve);
    const double middle = 0.5 * (right + left), reach = 0.5 * wing[i].share * (left - right);
    places.row(i) = face.curves.at(curve, middle - reach);
    places.row(2 * half - 1 - i) = face.curves.at(curve, middle + reach);
  }
  return smoothed(places);
}

}  // namespace

std::vector<ClosedCurves::Points> landmarkLines(const FaceCurves& face) {
  std::vector<ClosedCurves::Points> lines;
  for (const Arc& arc : arcs) {
    const FeaturePoint *from = face.feature(arc.from), *to = face.feature(arc.to);
    if (!from || !to) continue;
    ClosedCurves::Points line(pointsPerLine, 3);
    for (int i = 0; i < pointsPerLine; ++i)
      line.row(i) =
          face.curves.at(FaceLayout::curveIndex(arc.curve), from->v + (to->v - from->v) * i / (pointsPerLine - 1));
    lines.push_back(line);
  }
  const FeaturePoint *right = face.feature("9.2"), *left = face.feature("9.1");
  if (right && left) lines.push_back(noseLine(face, right->v, left->v));
  return lines;
}

}  // namespace mien
