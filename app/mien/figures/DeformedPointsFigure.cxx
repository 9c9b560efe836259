#include <algorithm>

#include "CatalogueFigures.h"
#include "DefaultRegions.h"
#include "FaceInPupilUnits.h"
#include "Failure.h"
#include "FigureContext.h"
#include "NamedTables.h"
#include "PlaneAxes.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "TableDeformation.h"

namespace mien {

namespace {

constexpr double pointSpacing = 0.28;  // of the points, pupil units
const char* const publishedTable = "smile";

/// Around the ends of the curves: down on one side and up on the other.
QPolygonF outlineOf(const std::vector<QPolygonF>& lines) {
  QPolygonF outline;
  for (const QPolygonF& line : lines) outline << line.first();
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) outline << line->last();
  return outline;
}

std::vector<DeformationPoint> pointsWithin(const QPolygonF& outline) {
  const QRectF bounds = outline.boundingRect();
  const Eigen::AlignedBox2d box(Eigen::Vector2d(bounds.left(), bounds.top()),
                                Eigen::Vector2d(bounds.right(), bounds.bottom()));
  std::vector<DeformationPoint> points;
  const int columns = static_cast<int>(0.5 * box.sizes().x() / pointSpacing);
  for (double y = box.max().y() - 0.5 * pointSpacing; y > box.min().y(); y -= pointSpacing)
    for (int i = -columns; i <= columns; ++i) {
      DeformationPoint point;
      point.position = {i * pointSpacing, y, 0.0};
      if (outline.containsPoint(QPointF(i * pointSpacing, y), Qt::OddEvenFill)) points.push_back(point);
    }
  return points;
}

/// Displacements of points that are in pupil units already.
std::vector<Eigen::Vector2d> displacements(const std::vector<DeformationPoint>& points, const DeformationTable& table,
                                           double strength, bool smooth) {
  PupilNormalisation pupils;
  pupils.set({1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  const FacialRegions& regions = defaultRegions();
  std::vector<Eigen::Vector2d> moves(points.size());
  TableDeformation(points, pupils, regions, smooth)
      .displacements(table, fittedDisplacement(table, regions), strength, 0, points.size(), moves.data());
  return moves;
}

void addPoint(PlaneDrawing& drawing, const Eigen::Vector2d& at, const QColor& color) {
  drawing.marks.push_back({{at.x(), at.y()}, 1.1, {color, 0.1, false, color}});
}

void addWay(PlaneDrawing& drawing, const Eigen::Vector2d& from, const Eigen::Vector2d& move) {
  if (move.norm() < 0.02) return;
  const Eigen::Vector2d to = from + move;
  drawing.lines.push_back(
      {segment(QPointF(from.x(), from.y()), QPointF(to.x(), to.y())), {QColor(), 0.4}, false, true});
}

}  // namespace

FigureDrawing drawDeformedPoints(FigureContext& context) {
  const FaceDeformation asked = context.state().deformation;
  const std::string name = asked.table.empty() ? publishedTable : asked.table;
  DeformationTable table;
  const std::string fault = readNamedTable(name, table);
  if (!fault.empty()) throw FileFailure(fault);
  const std::vector<QPolygonF> lines = frontalLines(context.neutralFace(), true);
  const auto points = pointsWithin(outlineOf(lines));
  const auto moves = displacements(points, table, asked.strength, asked.smooth);
  PlaneDrawing before, after;
  for (PlaneDrawing* drawing : {&before, &after}) addFaceBehind(*drawing, lines);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d at = points[i].position.head<2>();
    addPoint(before, at, QColor("#0072b2"));
    addPoint(after, at + moves[i], QColor("#d55e00"));
    addWay(after, at, moves[i]);
  }
  Plate plate;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  QRectF shown = before.bounds().united(after.bounds()), range = shown;
  for (PlaneDrawing* drawing : {&before, &after}) {
    for (const double x : {-1.0, 1.0}) drawing->marks.push_back({{x, 0.0}, 2.2, {QColor(), 0.7}});
    shown = addPlaneAxes(*drawing, range, 1.0, "pupil units", width);
  }
  plate.panels = {drawingPanel("Points of the neutral face", before, shown),
                  drawingPanel("Deformed by " + name, after, shown)};
  plate.caption = std::string(
                      "A lattice of points; the rings at (−1, 0) and (1, 0) are the pupils, grey curves those of the "
                      "neutral face. Each point is moved by the map of its region, ") +
                  (asked.smooth ? "blended smoothly at the borders." : "with the hard borders of the paper.");
  return context.drawn(plate);
}

}  // namespace mien
