#include <algorithm>

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
constexpr int steps = 4;             // intermediate positions that are drawn

struct MouthCase {
  const char* heading;
  std::vector<std::pair<int, double>> faps;
};

const std::vector<MouthCase>& mouthCases() {
  static const std::vector<MouthCase> cases = {
      {"51 = -200, 52 = -400: open", {{51, -200.0}, {52, -400.0}}},
      {"59, 60 = 250: corners up", {{59, 250.0}, {60, 250.0}}},
      {"53, 54 = 200: corners apart", {{53, 200.0}, {54, 200.0}}},
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

/// The four lip curves at rest, on their way (inner ones) and at the end; the ways of the inner samples.
PlaneDrawing mouthDrawing(FaceAnimator& face, const MouthCase& one) {
  const double corner = face.neutral().feature("8.3")->v + mouthMargin * M_PI / 180.0;
  PlaneDrawing drawing;
  std::vector<std::vector<QPolygonF>> ways(2);
  for (int step = 0; step <= steps; ++step) {
    const ClosedCurves moved = face.animate(frameOf(one, static_cast<double>(step) / steps));
    const CurveDrawing curves(moved, 2.0 * M_PI - corner, corner);
    const bool isEnd = step == steps;
    for (const int curve :
         {FaceLayout::upperLip - 1, FaceLayout::upperLip, FaceLayout::lowerLip, FaceLayout::lowerLip + 1}) {
      const bool isInner = curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip;
      if (!isEnd && step > 0 && !isInner) continue;
      PlaneStroke stroke = isEnd ? strokeOf(isInner ? "#d55e00" : "", 1.0) : strokeOf("#b8b8b8", 0.35);
      stroke.dashed = step == 0;
      drawing.lines.push_back({curves.line(curve), stroke});
      if (isInner) ways[curve - FaceLayout::upperLip].push_back(curves.samples(curve));
    }
  }
  for (const std::vector<QPolygonF>& lip : ways)
    for (int j = 0; j < lip.front().size(); ++j) {
      QPolygonF way;
      for (const QPolygonF& samples : lip) way << samples[j];
      if (QLineF(way.first(), way.last()).length() > 1.0)
        drawing.lines.push_back({way, strokeOf("#0072b2", 0.45), false, true});
    }
  return drawing;
}

}  // namespace

FigureDrawing drawMouth(FigureContext& context) {
  FaceAnimator face = boundFace(context);
  std::vector<PlaneDrawing> drawings;
  QRectF shown;
  for (const MouthCase& one : mouthCases()) {
    drawings.push_back(mouthDrawing(face, one));
    shown = shown.united(drawings.back().bounds());
  }
  Plate plate;
  plate.columns = context.isNarrow() ? 1 : 2;
  for (size_t i = 0; i < drawings.size(); ++i)
    plate.panels.push_back(drawingPanel(mouthCases()[i].heading, drawings[i], shown));
  plate.caption =
      "C21, C23 (outer) and the inner contours C22, C22' (orange) with the paths of their samples (blue); dashed: at "
      "rest, grey: in between. The contours open as one arch between the corners; where lips would cross, contact "
      "bends the paths. (d) All six FAPs of (a) to (c) together.";
  return context.drawn(plate);
}

}  // namespace mien
