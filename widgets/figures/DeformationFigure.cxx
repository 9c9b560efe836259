#include "DeformationFigure.h"

#include <cmath>
#include <string>

#include "DeviationText.h"
#include "PlaneDrawingPainter.h"
#include "PlatePainter.h"
#include "RealMinus.h"
#include "RegionCells.h"
#include "TextTable.h"

namespace mien {

namespace {

constexpr double narrowWidth = 120.0;  // mm; below it the two tables of coefficients stand below each other
constexpr double least = 0.01;         // pupil units as drawn; shorter arrows are dots
constexpr double keyHeight = 0.7;      // pupil units below the face, for the reference arrow
const QColor skinLine(150, 150, 150), featureLine(110, 110, 110), border(0, 114, 178), arrowColor(213, 94, 0);

QPolygonF polygonOf(const PlanePolygon& points) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : points) polygon << QPointF(point.x(), point.y());
  return polygon;
}

std::string shortNumber(double number) {
  return withRealMinus(QString::number(number, 'g', 3)).toStdString();
}

void addFace(PlaneDrawing& drawing, const DeformationFigureOptions& options) {
  for (const QPolygonF& line : options.faceLines) drawing.lines.push_back({line, {skinLine, 0.2}, false, false});
  for (const QPolygonF& line : options.featureLines) drawing.lines.push_back({line, {featureLine, 0.7}, false, false});
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
    drawing.labels.push_back({{centre.x(), centre.y()}, QString::number(region), 7.0, Qt::AlignCenter, {}, true, true});
  }
  return drawing;
}

void addArrow(PlaneDrawing& drawing, const QPointF& at, const QPointF& move) {
  QPolygonF line;
  line << at << at + move;
  if (std::hypot(move.x(), move.y()) < least)
    drawing.marks.push_back({at, 0.3, {arrowColor, 0.1, false, arrowColor}});
  else
    drawing.lines.push_back({line, {arrowColor, 0.45}, false, true});
}

/// 1, 2 or 5 times a power of ten that is drawn between 0.4 and 1 pupil units long.
double referenceLength(double magnification) {
  const double longest = 1.0 / magnification, power = std::pow(10.0, std::floor(std::log10(longest * (1.0 + 1e-9))));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= longest * (1.0 + 1e-9)) return digit * power;
  return power;
}

void addReference(PlaneDrawing& drawing, const QRectF& face, const DeformationFigureOptions& options) {
  const double length = referenceLength(options.magnification);
  const QPointF at(face.left(), face.top() - 0.6 * keyHeight), move(options.magnification * length, 0.0);
  addArrow(drawing, at, move);
  std::string text = shortNumber(length) + (length == 1.0 ? " pupil unit" : " pupil units");
  if (options.pupilUnit > 0.0) text += ", " + shortNumber(length * options.pupilUnit) + " mm";
  drawing.labels.push_back({at + move, QString::fromStdString(text), 6.0, Qt::AlignLeft, {}, false});
}

PlaneDrawing arrowDrawing(const FacialRegions& regions, const QRectF& face, const DeformationFigureOptions& options) {
  PlaneDrawing drawing;
  addFace(drawing, options);
  addBorders(drawing, regions, 0.25);
  for (const DeformationArrow& arrow : options.arrows) addArrow(drawing, arrow.at, options.magnification * arrow.move);
  addReference(drawing, face, options);
  return drawing;
}

PlatePanel coefficientPanel(const DeformationTable& table, int row, double width) {
  TextTable text;
  text.size = 5.0;
  text.columns.push_back({"", 0.55, false});
  for (int i = 1; i <= 6; ++i) text.columns.push_back({(row ? "b" : "a") + std::to_string(i), 1.0, true});
  for (int region = 0; region < FacialRegions::count; ++region) {
    text.rows.push_back({std::to_string(region + 1)});
    for (int i = 0; i < 6; ++i) {
      const double value = table.maps[region].coefficients(row, i);
      text.rows.back().push_back(table.deviations ? conciseText(value, table.deviations->at(region)(row, i))
                                                  : fixedText(value));
    }
  }
  const std::string axis = row ? "y'" : "x'";
  return tablePanel("Coefficients of " + axis + " by region", text, width);
}

std::string captionOf(const DeformationTable& table, const DeformationFigureOptions& options) {
  std::string caption =
      "Facial deformation table in pupil units (half the distance between the pupils, which are the dots; x to the "
      "subject's left). Arrows: ";
  caption += options.hard ? "hard, every point follows one region alone;" : "smooth, neighbouring regions blend;";
  caption += " the movement fades out at the face's outline.";
  if (options.coefficients) caption += " x' = a1 x² + a2 xy + a3 y² + a4 x + a5 y + a6, y' likewise with b1 .. b6.";
  if (options.coefficients && table.deviations)
    caption += " 0.123(4) stands for 0.123 ± 0.004, one standard deviation: the range of acceptable values.";
  return caption;
}

}  // namespace

double arrowSpacing(double width) {
  return width < narrowWidth ? 0.42 : 0.3;
}

Plate deformationPlate(const DeformationTable& table, const FacialRegions& regions,
                       const DeformationFigureOptions& options, double width) {
  Plate plate;
  const QRectF face = polygonOf(faceOutline(regions)).boundingRect();
  const PlaneDrawing arrows = arrowDrawing(regions, face, options);
  const QRectF shown = face.adjusted(0.0, -keyHeight, 0.0, 0.0).united(arrows.bounds());
  plate.panels.push_back(drawingPanel("Regions", regionDrawing(regions, options), shown));
  plate.panels.push_back(
      drawingPanel("Displacements, " +
                       (options.magnification == 1.0 ? "true to scale" : shortNumber(options.magnification) + " times"),
                   arrows, shown));
  const int span = width < narrowWidth ? 2 : 1;
  for (int row = 0; row < (options.coefficients ? 2 : 0); ++row) {
    plate.panels.push_back(coefficientPanel(table, row, PlatePainter::panelWidth(width, plate.columns, span)));
    plate.panels.back().span = span;
  }
  plate.caption = captionOf(table, options);
  return plate;
}

}  // namespace mien
