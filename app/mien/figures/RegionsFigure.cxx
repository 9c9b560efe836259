#include "CatalogueFigures.h"
#include "DefaultRegions.h"
#include "FaceInPupilUnits.h"
#include "FigureContext.h"
#include "PlaneAxes.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "RegionCells.h"
#include "TextTable.h"

namespace mien {

namespace {

/// Mirror pairs have one colour; neighbours have different ones.
QColor regionColor(int region) {
  static const char* const colors[] = {"#56b4e9", "#e69f00", "#009e73", "#f0e442", "#cc79a7", "#0072b2", "#d55e00"};
  static const int ofRegion[FacialRegions::count] = {0, 0, 1, 2, 2, 3, 3, 4, 5, 6, 6, 0, 2, 1, 1, 4};
  QColor color(colors[ofRegion[region - 1]]);
  color.setAlphaF(0.35);
  return color;
}

QPolygonF polygonOf(const PlanePolygon& points) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : points) polygon << QPointF(point.x(), point.y());
  return polygon;
}

PlaneDrawing regionDrawing(FigureContext& context) {
  const FacialRegions& regions = defaultRegions();
  PlaneDrawing drawing;
  int region = 0;
  for (const PlanePolygon& cell : regionCells(regions)) {
    PlaneStroke stroke = {context.settings().theme.axis, 0.6};
    stroke.fill = regionColor(++region);
    if (cell.size() > 2) drawing.lines.push_back({polygonOf(cell), stroke, true});
  }
  addFaceBehind(drawing, frontalLines(context.neutralFace(), true));
  for (const double x : {-1.0, 1.0})
    drawing.marks.push_back({{x, 0.0}, 1.6, {QColor(), 0.5, false, context.settings().theme.background}});
  for (region = 1; region <= FacialRegions::count; ++region) {
    const Eigen::Vector2d& centre = regions.centre(region);
    drawing.labels.push_back({{centre.x(), centre.y()}, QString::number(region), 8.0, Qt::AlignCenter, {}, true, true});
  }
  return drawing;
}

TextTable nameTable() {
  TextTable table;
  table.close = true;
  table.columns = {{"Region", 0.6}, {"Part of the face", 1.6}, {"Mirror", 0.6}};
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const int mirror = defaultRegions().mirrored(region);
    table.rows.push_back(
        {std::to_string(region), defaultRegions().name(region), mirror == region ? "midline" : std::to_string(mirror)});
  }
  return table;
}

}  // namespace

FigureDrawing drawRegions(FigureContext& context) {
  Plate plate;
  plate.columns = context.isNarrow() ? 1 : 2;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  PlaneDrawing regions = regionDrawing(context);
  const QRectF shown = addPlaneAxes(regions, regions.bounds(), 1.0, "pupil units", width);
  plate.panels = {drawingPanel("Regions", regions, shown), tablePanel("Names", nameTable(), width)};
  plate.caption =
      "A point belongs to the nearest of 16 centres (numbers); colours only tell neighbours apart. Circles: the pupils "
      "at "
      "(−1, 0) and (1, 0).";
  return context.drawn(plate);
}

}  // namespace mien
