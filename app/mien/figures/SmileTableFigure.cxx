#include <cmath>

#include "CatalogueFigures.h"
#include "FacialRegions.h"
#include "FigureContext.h"
#include "NamedTables.h"
#include "PlatePainter.h"
#include "TextTable.h"

namespace mien {

namespace {

std::string number(double value) {
  const double rounded = std::round(100.0 * value) / 100.0;
  return QString::number(rounded == 0.0 ? 0.0 : rounded, 'f', 2).replace('-', "−").toStdString();
}

std::string withDeviation(const DeformationTable& table, int region, int row, int i) {
  return number(table.maps[region].coefficients(row, i)) + "\u2009±\u2009" +
         number(table.deviations->at(region)(row, i));
}

enum Columns { Published = 1, Mean = 2 };

std::vector<std::string> cellsOf(int columns, int region, int row) {
  std::vector<std::string> cells = {std::to_string(region + 1)};
  for (int i = 0; i < 6 && (columns & Published); ++i)
    cells.push_back(number(namedTable("smile")->maps[region].coefficients(row, i)));
  for (int i = 0; i < 6 && (columns & Mean); ++i) cells.push_back(withDeviation(*namedTable("joy"), region, row, i));
  return cells;
}

/// The tables of one axis, side by side where both are asked for, a row for each region.
PlatePanel coefficientPanel(int columns, int row, double width) {
  TextTable text;
  text.size = columns == Mean ? 5.5 : 6.0;     // six numbers with deviations in one column of a page
  text.close = columns != (Published | Mean);  // four tables one below the other are as high as a page
  text.columns.push_back({"Region", 0.3});
  text.groups.push_back({"", 1});
  const std::string letter = row ? "b" : "a";
  for (int i = 1; i <= 6 && (columns & Published); ++i) text.columns.push_back({letter + std::to_string(i), 0.8, true});
  for (int i = 1; i <= 6 && (columns & Mean); ++i) text.columns.push_back({letter + std::to_string(i), 1.4, true});
  if (columns & Published) text.groups.push_back({"Table I", 6});
  if (columns & Mean) text.groups.push_back({"Mien's mean smile", 6});
  for (int region = 0; region < FacialRegions::count; ++region) text.rows.push_back(cellsOf(columns, region, row));
  return tablePanel(
      row ? "y' = b1 x² + b2 xy + b3 y² + b4 x + b5 y + b6" : "x' = a1 x² + a2 xy + a3 y² + a4 x + a5 y + a6", text,
      width);
}

}  // namespace

FigureDrawing drawSmileTable(FigureContext& context) {
  Plate plate;
  plate.columns = 1;
  std::vector<int> panels = {Published | Mean};
  if (context.isNarrow()) panels = {Published, Mean};
  for (int row = 0; row < 2; ++row)
    for (const int columns : panels) plate.panels.push_back(coefficientPanel(columns, row, context.innerWidth()));
  plate.caption =
      "The published smile beside Mien's own mean smile, in pupil units, rounded to two decimals; ± is one standard "
      "deviation over the "
      "12 subjects (n = 12).";
  return context.drawn(plate);
}

}  // namespace mien
