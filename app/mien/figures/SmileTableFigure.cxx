#include "CatalogueFigures.h"
#include "FacialRegions.h"
#include "FigureContext.h"
#include "NamedTables.h"
#include "PlatePainter.h"
#include "TextTable.h"

namespace mien {

namespace {

std::string number(double value) {
  return QString::number(value, 'f', 2).toStdString();
}

/// "0.12 ±0.03" where the table has deviations.
std::string cell(const DeformationTable& table, int region, int row, int column) {
  const std::string value = number(table.maps[region].coefficients(row, column));
  return table.deviations ? value + " ±" + number(table.deviations->at(region)(row, column)) : value;
}

PlatePanel coefficientPanel(const std::string& heading, const DeformationTable& table, int row, double width) {
  TextTable text;
  text.size = 5.5;
  text.columns.push_back({"Region", 0.8});
  for (int i = 1; i <= 6; ++i) text.columns.push_back({(row ? "b" : "a") + std::to_string(i), 1.0, true});
  for (int region = 0; region < FacialRegions::count; ++region) {
    text.rows.push_back({std::to_string(region + 1)});
    for (int i = 0; i < 6; ++i) text.rows.back().push_back(cell(table, region, row, i));
  }
  return tablePanel(heading, text, width);
}

}  // namespace

FigureDrawing drawSmileTable(FigureContext& context) {
  Plate plate;
  plate.columns = context.settings().width < 120.0 ? 1 : 2;
  const double width = PlatePainter::panelWidth(context.settings().width, plate.columns, 1);
  for (int row = 0; row < 2; ++row) {
    const std::string axis = row ? ", y'" : ", x'";
    plate.panels.push_back(coefficientPanel("Table I, smile" + axis, *namedTable("smile"), row, width));
    plate.panels.push_back(coefficientPanel("Mean joy of 12 subjects" + axis, *namedTable("joy"), row, width));
  }
  plate.caption =
      "The published smile beside Mien's own mean smile, in pupil units; ± is one standard deviation over the "
      "subjects.";
  return context.drawn(plate);
}

}  // namespace mien
