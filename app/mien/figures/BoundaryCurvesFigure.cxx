#include <algorithm>

#include "CatalogueFigures.h"
#include "CurveDrawing.h"
#include "FaceLayout.h"
#include "FigureContext.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr double twoColumns = 120.0;  // mm: below this the panels stand one below the other
constexpr double nameHeight = 2.2;    // mm on paper that a name needs
constexpr double nameWidth = 6.3;     // mm on paper, of "C22'"
constexpr double leaders = 8.0;       // mm of the face, from the curves to their names
constexpr double patchesWidth = 6.0;  // mm on paper: brackets and names of the patches

/// C1, C3 .. or C2, C4 ..: names alternate between the sides.
std::vector<int> everySecond(int first) {
  std::vector<int> curves;
  for (int curve = first; curve < FaceLayout::curveCount; curve += 2) curves.push_back(curve);
  return curves;
}

/// mm of the face for one on paper, with room for names on both sides and for the brackets on the left.
double faceScale(const CurveDrawing& face, double panelWidth) {
  return (face.bounds().width() + 2.0 * leaders) / (panelWidth - 2.0 * nameWidth - patchesWidth);
}

/// Whether a patch ends at a curve and another begins; at the mouth one ends at C22 and the next begins at C22'.
bool isShared(int curve) {
  const auto* const begin = std::begin(FaceLayout::firstCurve);
  return curve == FaceLayout::upperLip ||
         std::find(begin + 1, begin + FaceLayout::patchCount, curve) != begin + FaceLayout::patchCount;
}

PlaneDrawing labelledCurves(const ClosedCurves& curves, double panelWidth) {
  PlaneDrawing drawing;
  const CurveDrawing face(curves);
  face.addLines(drawing, [](int curve) {
    PlaneStroke stroke;
    stroke.width = isShared(curve) ? 1.0 : 0.45;
    if (curve == FaceLayout::upperLip || curve == FaceLayout::lowerLip) stroke.color = QColor("#d55e00");
    if (curve == FaceLayout::lowerLip) stroke = {QColor("#0072b2"), 1.0, true};
    return stroke;
  });
  const double scale = faceScale(face, panelWidth), gap = nameHeight * scale;
  face.addNames(drawing, everySecond(0), true, gap);
  face.addNames(drawing, everySecond(1), false, gap);
  face.addPatchNames(drawing, leaders + nameWidth * scale);
  return drawing;
}

}  // namespace

FigureDrawing drawBoundaryCurves(FigureContext& context) {
  const FaceState& rest = context.state();  // at rest, as the catalogue has it
  FaceState open = rest;
  open.fapValues[51] -= 120.0;
  open.fapValues[52] -= 450.0;
  const int columns = context.settings().width < twoColumns ? 1 : 2;
  const double width = PlatePainter::panelWidth(context.settings().width, columns, 1);
  const PlaneDrawing closedMouth = labelledCurves(context.curves(rest).curves, width);
  const PlaneDrawing openMouth = labelledCurves(context.curves(open).curves, width);
  const double side = nameWidth * faceScale(CurveDrawing(context.curves(rest).curves), width);
  const QRectF shown = closedMouth.bounds().united(openMouth.bounds()).adjusted(-0.7 * side, 0.0, side, 0.0);
  Plate plate;
  plate.columns = columns;
  plate.panels = {drawingPanel("Mouth closed: C22 and C22' coincide", closedMouth, shown),
                  drawingPanel("Mouth open", openMouth, shown)};
  plate.caption =
      "The 29 boundary curves of the frontal half and the nine patches P0 .. P8, each between four of them. Thick: "
      "curves "
      "at which two patches meet; among them the inner contours C22 (upper, orange) and C22' (lower, dashed blue).";
  return context.drawn(plate);
}

}  // namespace mien
