#include <algorithm>

#include "CatalogueFigures.h"
#include "CurveDrawing.h"
#include "FaceLayout.h"
#include "FigureContext.h"
#include "MotionPanel.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"

namespace mien {

namespace {

constexpr const char* movedCurve = "C6";
constexpr double activatedValue = 300.0;  // FAP units
constexpr double visibleShare = 0.02;     // of the largest motion: less is no part of the active area
constexpr double frontal[2] = {0.5 * M_PI, 1.5 * M_PI};

FaceState raisedBrows(const FaceState& rest) {
  FaceState state = rest;
  for (int fap = 31; fap <= 36; ++fap) state.fapValues[fap] += activatedValue;
  return state;
}

/// First and last row of the grid in which something moves.
std::array<int, 2> activeRows(const MotionField& field) {
  const Eigen::VectorXd length = field.magnitudes();
  std::array<int, 2> rows = {static_cast<int>(length.size()), 0};
  for (int i = 0; i < length.size(); ++i) {
    if (length[i] < visibleShare * length.maxCoeff()) continue;
    rows[0] = std::min(rows[0], i / field.columns);
    rows[1] = std::max(rows[1], i / field.columns);
  }
  return rows;
}

/// The frontal half of a row of the grid, before or after the motion.
QPolygonF gridLine(const MotionField& field, int row, bool moved) {
  QPolygonF line;
  for (int i = row * field.columns; i < (row + 1) * field.columns; ++i) {
    if (field.v[i] < frontal[0] || field.v[i] > frontal[1]) continue;
    const Eigen::RowVector3d point = field.origins.row(i) + (moved ? 1.0 : 0.0) * field.vectors.row(i);
    line << QPointF(point.x(), point.y());
  }
  return line;
}

/// The strip of the surface that moves, and the lines of the grid in it.
void addActiveArea(PlaneDrawing& drawing, const MotionField& field, bool moved) {
  const auto [first, last] = activeRows(field);
  QPolygonF area = gridLine(field, first, moved);
  for (int row = first + 1; row < last; ++row) area << gridLine(field, row, moved).last();
  const QPolygonF lower = gridLine(field, last, moved);
  std::copy(lower.rbegin(), lower.rend(), std::back_inserter(area));
  for (int row = last - 1; row > first; --row) area << gridLine(field, row, moved).first();
  PlaneStroke fill, line;
  fill.width = 0.0;
  fill.fill = QColor(86, 180, 233, 60);
  line.width = 0.3;
  line.color = QColor("#56b4e9");
  drawing.lines.push_back({area, fill, true});
  for (int row = first; row <= last; ++row) drawing.lines.push_back({gridLine(field, row, moved), line});
}

PlaneDrawing areaDrawing(const ClosedCurves& curves, const MotionField& field, bool moved) {
  PlaneDrawing drawing;
  addActiveArea(drawing, field, moved);
  CurveDrawing(curves).addLines(drawing, [](int curve) {
    PlaneStroke stroke;
    const bool isMoved = curve == FaceLayout::curveIndex(movedCurve);
    stroke.width = isMoved ? 1.2 : 0.45;
    if (isMoved) stroke.color = QColor("#d55e00");
    return stroke;
  });
  return drawing;
}

}  // namespace

FigureDrawing drawActiveArea(FigureContext& context) {
  FaceState rest = context.state();
  rest.rows = std::max(rest.rows, 56);
  const FaceState raised = raisedBrows(rest);
  const MotionField field = context.motion(raised, rest);
  const PlaneDrawing before = areaDrawing(context.curves(rest).curves, field, false);
  const PlaneDrawing after = areaDrawing(context.curves(raised).curves, field, true);
  const QRectF shown = before.bounds().united(after.bounds());
  Plate plate;
  plate.columns = context.isNarrow() ? 2 : 3;
  MotionVectorOptions options = context.vectorOptions();
  const int span = context.isNarrow() ? 2 : 1;
  options.width = PlatePainter::panelWidth(context.settings().width, plate.columns, span);
  plate.panels = {drawingPanel("Before", before, shown), drawingPanel("After", after, shown),
                  motionPanel("Motion of the active area", {{field, ""}}, options)};
  plate.panels.back().span = span;
  plate.caption =
      "The brows' curve C6 (orange) is raised by FAPs 31 to 36 = 300; the curves beside it follow by their weights in "
      "the animation table. Blue: the rows of the surface "
      "that move by more than 2 % of the largest motion.";
  return context.drawn(plate);
}

}  // namespace mien
