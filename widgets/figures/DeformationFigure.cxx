#include "DeformationFigure.h"

#include <cstdio>

#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "RegionCells.h"
#include "TextTable.h"

namespace mien {

namespace {

constexpr double narrowWidth = 120.0;  // mm; below it the two tables of coefficients stand below each other
const QColor skinLine(150, 150, 150), border(90, 90, 90), arrowColor(213, 94, 0), numberColor(0, 114, 178);

QPolygonF polygonOf(const PlanePolygon& points) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : points) polygon << QPointF(point.x(), point.y());
  return polygon;
}

void addFace(PlaneDrawing& drawing, const DeformationFigureOptions& options) {
  for (const QPolygonF& line : options.faceLines) drawing.lines.push_back({line, {skinLine, 0.3}, false, false});
  for (const double x : {-1.0, 1.0}) drawing.marks.push_back({{x, 0.0}, 1.2, {skinLine, 0.5, false, skinLine}});
}

void addBorders(PlaneDrawing& drawing, const FacialRegions& regions, double width) {
  for (const PlanePolygon& cell : regionCells(regions))
    if (cell.size() > 2) drawing.lines.push_back({polygonOf(cell), {border, width}, true, false});
}

PlaneDrawing regionDrawing(const FacialRegions& regions, const DeformationFigureOptions& options) {
  PlaneDrawing drawing;
  addFace(drawing, options);
  addBorders(drawing, regions, 0.6);
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Eigen::Vector2d& centre = regions.centre(region);
    drawing.labels.push_back(
        {{centre.x(), centre.y()}, QString::number(region), 7.0, Qt::AlignCenter, numberColor, true});
  }
  return drawing;
}

PlaneDrawing arrowDrawing(const DeformationTable& table, const FacialRegions& regions,
                          const DeformationFigureOptions& options) {
  PlaneDrawing drawing;
  addFace(drawing, options);
  addBorders(drawing, regions, 0.25);
  const QRectF bounds = polygonOf(faceOutline(regions)).boundingRect();
  const int rows = static_cast<int>(bounds.height() / options.spacing);
  const int columns = static_cast<int>(0.5 * bounds.width() / options.spacing);
  for (int row = 0; row <= rows; ++row)
    for (int column = -columns; column <= columns; ++column) {
      const Eigen::Vector2d point(bounds.center().x() + column * options.spacing,
                                  bounds.center().y() + (row - 0.5 * rows) * options.spacing);
      if (regions.outlineWeight(point) < 0.5) continue;
      const Eigen::Vector2d move =
          options.magnification * (table.maps[regions.nearest(point) - 1].apply(point) - point);
      if (move.norm() < 0.02) {
        drawing.marks.push_back({{point.x(), point.y()}, 0.4, {arrowColor, 0.1, false, arrowColor}});
        continue;
      }
      QPolygonF line;
      line << QPointF(point.x(), point.y()) << QPointF(point.x() + move.x(), point.y() + move.y());
      drawing.lines.push_back({line, {arrowColor, 0.5}, false, true});
    }
  return drawing;
}

std::string cell(double value, const DeformationTable& table, int region, int row, int column) {
  char text[64];
  if (table.deviations)
    std::snprintf(text, sizeof text, "%.3f ±%.3f", value, table.deviations->at(region)(row, column));
  else
    std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

PlatePanel coefficientPanel(const DeformationTable& table, int row, double width) {
  TextTable text;
  text.size = 6.0;
  text.columns.push_back({"Region", 0.8, false});
  for (int i = 1; i <= 6; ++i) text.columns.push_back({(row ? "b" : "a") + std::to_string(i), 1.0, true});
  for (int region = 0; region < FacialRegions::count; ++region) {
    text.rows.push_back({std::to_string(region + 1)});
    for (int i = 0; i < 6; ++i)
      text.rows.back().push_back(cell(table.maps[region].coefficients(row, i), table, region, row, i));
  }
  const std::string axis = row ? "y'" : "x'";
  return tablePanel("Coefficients of " + axis, text, width);
}

}  // namespace

Plate deformationPlate(const DeformationTable& table, const FacialRegions& regions,
                       const DeformationFigureOptions& options, double width) {
  Plate plate;
  const QRectF shown = polygonOf(faceOutline(regions)).boundingRect();
  char factor[32];
  std::snprintf(factor, sizeof factor, "%.3g", options.magnification);
  plate.panels.push_back(drawingPanel("Regions", regionDrawing(regions, options), shown));
  plate.panels.push_back(
      drawingPanel(std::string("Displacements, ") + factor + " times", arrowDrawing(table, regions, options), shown));
  const int span = width < narrowWidth ? 2 : 1;
  for (int row = 0; row < (options.coefficients ? 2 : 0); ++row) {
    plate.panels.push_back(coefficientPanel(table, row, PlatePainter::panelWidth(width, plate.columns, span)));
    plate.panels.back().span = span;
  }
  plate.caption =
      "Facial deformation table in pupil units (half the distance between the pupils, which are the dots; x to the "
      "subject's left).";
  if (options.coefficients)
    plate.caption += " x' = a1 x² + a2 xy + a3 y² + a4 x + a5 y + a6, y' likewise with b1 .. b6.";
  if (options.coefficients && table.deviations)
    plate.caption += " ± is one standard deviation, the range of acceptable values.";
  return plate;
}

}  // namespace mien
