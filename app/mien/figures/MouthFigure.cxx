#include <algorithm>
#include <cmath>

#include "BoundFace.h"
#include "CatalogueFigures.h"
#include "CurveDrawing.h"
#include "FAPTable.h"
#include "FaceLayout.h"
#include "FigureContext.h"
#include "PlaneDrawingPainter.h"

namespace mien {

namespace {

constexpr int upperLipFAP = 51, lowerLipFAP = 52;
constexpr double mouthMargin = 6.0;  // degrees of v beyond the corners
constexpr double leastBend = 0.05;   // mm, of a path that is called bent
constexpr int steps = 4;             // intermediate positions that are drawn

struct MouthCase {
  const char* heading;
  std::vector<std::pair<int, double>> faps;
};

const std::vector<MouthCase>& mouthCases() {
  static const std::vector<MouthCase> cases = {
      {"FAP 51 = −200, FAP 52 = −400: open", {{51, -200.0}, {52, -400.0}}},
      {"FAP 59, FAP 60 = 250: corners up", {{59, 250.0}, {60, 250.0}}},
      {"FAP 53, FAP 54 = 200: corners apart", {{53, 200.0}, {54, 200.0}}},
      {"All six FAPs", {{51, -200.0}, {52, -400.0}, {53, 200.0}, {54, 200.0}, {59, 250.0}, {60, 250.0}}}};
  return cases;
}

FAPFrame frameOf(const MouthCase& one, double share) {
  FAPFrame frame;
  for (const auto& [fap, value] : one.faps) frame.setValue(fap, share * value);
  return frame;
}

PlaneStroke strokeOf(const char* color, double width) {
  PlaneStroke stroke;
  stroke.color = QColor(color);
  stroke.width = width;
  return stroke;
}

bool isInner(int curve) {
  return curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip;
}

/// A panel's drawing, and how far the paths in it bend.
struct Mouth {
  PlaneDrawing drawing;
  double bend = 0.0;  ///< mm, from the straight line between their ends
};

PlaneStroke curveStroke(int curve, int step) {
  if (step == 0) return strokeOf("#8a8a8a", 0.6);
  if (step < steps) return strokeOf("#c4c4c4", 0.35);
  return isInner(curve) ? strokeOf("#d55e00", 1.3) : strokeOf("", 0.9);
}

double distanceFromChord(const QPolygonF& way) {
  const QPointF chord = way.last() - way.first();
  double most = 0.0;
  for (const QPointF& p : way) {
    const QPointF from = p - way.first();
    most = std::max(most, std::abs(chord.x() * from.y() - chord.y() * from.x()) / std::hypot(chord.x(), chord.y()));
  }
  return most;
}

void addWays(Mouth& mouth, const std::vector<QPolygonF>& lip) {
  PlaneStroke stroke = strokeOf("#0072b2", 0.7);
  stroke.dashed = true;
  for (int j = 0; j < lip.front().size(); ++j) {
    QPolygonF way;
    for (const QPolygonF& samples : lip) way << samples[j];
    if (QLineF(way.first(), way.last()).length() <= 1.0) continue;
    mouth.drawing.lines.push_back({way, stroke, false, true});
    mouth.bend = std::max(mouth.bend, distanceFromChord(way));
  }
}

void addName(PlaneDrawing& drawing, const QPointF& at, const QString& text, int alignment) {
  PlaneDrawing::Label label;
  label.at = at;
  label.text = text;
  label.alignment = alignment;
  label.halo = true;
  drawing.labels.push_back(label);
}

/// The outer contours at their right ends; the inner ones there too where they meet, else in the middle, apart.
void addNames(PlaneDrawing& drawing, const CurveDrawing& curves) {
  constexpr double leastGap = 6.0;  // mm
  const QPolygonF upper = curves.line(FaceLayout::upperLip), lower = curves.line(FaceLayout::lowerLip);
  const auto end = [&](int curve) { return curves.line(curve).last(); };
  const QPointF above = upper[upper.size() / 2], below = lower[lower.size() / 2];
  addName(drawing, end(FaceLayout::upperLip - 1), "C21", Qt::AlignLeft | Qt::AlignVCenter);
  addName(drawing, end(FaceLayout::lowerLip + 1), "C23", Qt::AlignLeft | Qt::AlignVCenter);
  if (above.y() - below.y() < leastGap)
    return addName(drawing, end(FaceLayout::upperLip), "C22, C22'", Qt::AlignLeft | Qt::AlignVCenter);
  addName(drawing, above, "C22", Qt::AlignHCenter | Qt::AlignBottom);
  addName(drawing, below, "C22'", Qt::AlignHCenter | Qt::AlignTop);
}

/// The four lip curves at rest, on their way (inner ones) and at the end; the ways of the inner samples.
Mouth mouthDrawing(FaceAnimator& face, const MouthCase& one) {
  const double corner = face.neutral().feature("8.3")->v + mouthMargin * M_PI / 180.0;
  Mouth mouth;
  std::vector<std::vector<QPolygonF>> ways(2);
  for (int step = 0; step <= steps; ++step) {
    const ClosedCurves moved = face.animate(frameOf(one, static_cast<double>(step) / steps));
    const CurveDrawing curves(moved, 2.0 * M_PI - corner, corner);
    for (int curve = FaceLayout::upperLip - 1; curve <= FaceLayout::lowerLip + 1; ++curve) {
      if (step > 0 && step < steps && !isInner(curve)) continue;
      mouth.drawing.lines.push_back({curves.line(curve), curveStroke(curve, step)});
      if (isInner(curve)) ways[curve - FaceLayout::upperLip].push_back(curves.samples(curve));
    }
    if (step == steps) addNames(mouth.drawing, curves);
  }
  for (const std::vector<QPolygonF>& lip : ways) addWays(mouth, lip);
  return mouth;
}

/// All panels at one scale, each as high as its own curves; names stand on the right.
QRectF shownPart(const PlaneDrawing& drawing, const QRectF& all) {
  constexpr double nameRoom = 9.0;  // mm
  const QRectF own = drawing.bounds();
  return QRectF(all.left(), own.top(), all.width() + nameRoom, own.height());
}

}  // namespace

FigureDrawing drawMouth(FigureContext& context) {
  FaceAnimator face = boundFace(context);
  std::vector<Mouth> mouths;
  QRectF all;
  double bend = 0.0;
  for (const MouthCase& one : mouthCases()) {
    mouths.push_back(mouthDrawing(face, one));
    all = all.united(mouths.back().drawing.bounds());
    bend = std::max(bend, mouths.back().bend);
  }
  Plate plate;
  plate.columns = context.isNarrow() ? 1 : 2;
  for (size_t i = 0; i < mouths.size(); ++i)
    plate.panels.push_back(drawingPanel(mouthCases()[i].heading, mouths[i].drawing, shownPart(mouths[i].drawing, all)));
  plate.caption =
      "Outer contours C21, C23 (black), inner contours C22, C22' (thick, orange) and the paths of their samples "
      "(dashed "
      "arrows, blue); dark grey: at rest, light grey: in between. The contours open as one arch between the corners; " +
      (bend < leastBend ? std::string("all paths are straight.")
                        : "where the lips would cross, contact bends the paths, by up to " +
                              QString::number(bend, 'f', 1).toStdString() + " mm.") +
      " (d) All six FAPs of (a) to (c) together.";
  return context.drawn(plate);
}

}  // namespace mien
