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
  return number(table.maps[region].coefficients(row, i)) + " ± " + number(table.deviations->at(region)(row, i));
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
  text.size = 6.0;
  text.close = columns != (Published | Mean);  // four tables one below the other are as high as a page
  text.columns.push_back({"", 0.3});
  const std::string letter = row ? "b" : "a";
  for (int i = 1; i <= 6 && (columns & Published); ++i) text.columns.push_back({letter + std::to_string(i), 0.8, true});
  for (int i = 1; i <= 6 && (columns & Mean); ++i)
    text.columns.push_back({"mean " + letter + std::to_string(i), 1.4, true});
  for (int region = 0; region < FacialRegions::count; ++region) text.rows.push_back(cellsOf(columns, region, row));
  const std::string of = columns == Published ? ", Table I" : columns == Mean ? ", mean" : "";
  return tablePanel((row ? "y'" : "x'") + of, text, width);
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
      "The published smile beside Mien's own mean smile, in pupil units; ± is one standard deviation over the "
      "12 subjects (n = 12).";
  return context.drawn(plate);
}

}  // namespace mien
