#include <algorithm>

#include "CatalogueFigures.h"
#include "CurveDrawing.h"
#include "FaceLayout.h"
#include "FaceMotion.h"
#include "FigureContext.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr double twoColumns = 120.0;  // mm: below this the panels stand one below the other
constexpr double nameHeight = 2.0;    // mm on paper that a name needs
constexpr double namesShare = 1.35;   // width of the panel over that of the curves: room for names on both sides

/// C1, C3 .. or C2, C4 ..: names alternate between the sides.
std::vector<int> everySecond(int first) {
  std::vector<int> curves;
  for (int curve = first; curve < FaceLayout::curveCount; curve += 2) curves.push_back(curve);
  return curves;
}

PlaneDrawing labelledCurves(const ClosedCurves& curves, double panelWidth) {
  PlaneDrawing drawing;
  const CurveDrawing face(curves);
  face.addLines(drawing, [](int curve) {
    PlaneStroke stroke;
    const bool isSeam = curve % 3 == 0 && curve < FaceLayout::upperLip;
    stroke.width = isSeam ? 0.8 : 0.45;
    if (curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip) stroke.color = QColor("#d55e00");
    return stroke;
  });
  const double gap = nameHeight * namesShare * face.bounds().width() / panelWidth;
  face.addNames(drawing, everySecond(0), true, gap);
  face.addNames(drawing, everySecond(1), false, gap);
  return drawing;
}

}  // namespace

FigureDrawing drawBoundaryCurves(FigureContext& context) {
  const FaceState rest = FaceMotion::neutralOf(context.state());
  FaceState open = rest;
  open.fapValues[51] -= 120.0;
  open.fapValues[52] -= 450.0;
  const int columns = context.settings().width < twoColumns ? 1 : 2;
  const double width = PlatePainter::panelWidth(context.settings().width, columns, 1);
  const PlaneDrawing closedMouth = labelledCurves(context.curves(rest).curves, width);
  const PlaneDrawing openMouth = labelledCurves(context.curves(open).curves, width);
  const QRectF shown = closedMouth.bounds().united(openMouth.bounds()).adjusted(-9.0, 0.0, 9.0, 0.0);
  Plate plate;
  plate.columns = columns;
  plate.panels = {drawingPanel("Mouth closed: C22 and C22' coincide", closedMouth, shown),
                  drawingPanel("Mouth open", openMouth, shown)};
  plate.caption =
      "Thick: curves between patches (P0 = C1 .. C4, P1 = C4 .. C7, P2 = C7 .. C10, P3 = C10 .. C13, P4 = C13 .. C16, "
      "P5 = C16 .. C19, P6 = C19 .. C22, P7 = C22' .. C25, P8 = C25 .. C28); orange: the inner contours C22 (upper) "
      "and C22' (lower).";
  return context.drawn(plate);
}

}  // namespace mien
