#include "LandmarkLines.h"

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

constexpr const char* wingCurves[] = {"C15", "C16", "C17"};  // downwards

/// Down one wing, along the base of the nose and up the other wing.
ClosedCurves::Points noseLine(const FaceCurves& face, double right, double left) {
  const int wing = static_cast<int>(std::size(wingCurves));
  ClosedCurves::Points line(2 * wing + pointsPerLine, 3);
  for (int i = 0; i < wing; ++i) {
    const int curve = FaceLayout::curveIndex(wingCurves[i]);
    line.row(i) = face.curves.at(curve, right);
    line.row(line.rows() - 1 - i) = face.curves.at(curve, left);
  }
  const int base = FaceLayout::curveIndex("C18");
  for (int i = 0; i < pointsPerLine; ++i)
    line.row(wing + i) = face.curves.at(base, right + (left - right) * i / (pointsPerLine - 1));
  return line;
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
