#include "LandmarkLines.h"

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

constexpr Arc arcs[] = {{"C9", "3.11", "3.7"},  {"C10", "3.11", "3.7"}, {"C9", "3.12", "3.8"},
                        {"C10", "3.12", "3.8"}, {"C6", "4.1", "4.5"},   {"C6", "4.6", "4.2"},
                        {"C18", "9.2", "9.1"},  {"C21", "8.4", "8.3"},  {"C23", "8.4", "8.3"}};

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
  return lines;
}

}  // namespace mien
