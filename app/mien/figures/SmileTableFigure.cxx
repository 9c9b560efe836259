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
  return QString::number(rounded == 0.0 ? 0.0 : rounded, 'f', 2).toStdString();
}

/// Both tables of one axis side by side, a row for each region.
PlatePanel coefficientPanel(const DeformationTable& published, const DeformationTable& mean, int row, double width) {
  TextTable text;
  text.size = 5.5;
  text.columns.push_back({"Region", 0.9});
  const std::string letter = row ? "b" : "a";
  for (int i = 1; i <= 6; ++i) text.columns.push_back({letter + std::to_string(i), 0.8, true});
  for (int i = 1; i <= 6; ++i) text.columns.push_back({"mean " + letter + std::to_string(i), 1.4, true});
  for (int region = 0; region < FacialRegions::count; ++region) {
    std::vector<std::string> cells = {std::to_string(region + 1)};
    for (int i = 0; i < 6; ++i) cells.push_back(number(published.maps[region].coefficients(row, i)));
    for (int i = 0; i < 6; ++i)
      cells.push_back(number(mean.maps[region].coefficients(row, i)) + " ±" +
                      number(mean.deviations->at(region)(row, i)));
    text.rows.push_back(cells);
  }
  return tablePanel(row ? "y'" : "x'", text, width);
}

}  // namespace

FigureDrawing drawSmileTable(FigureContext& context) {
  Plate plate;
  plate.columns = 1;
  for (int row = 0; row < 2; ++row)
    plate.panels.push_back(coefficientPanel(*namedTable("smile"), *namedTable("joy"), row, context.innerWidth()));
  plate.caption =
      "The published smile beside Mien's own mean smile, in pupil units; ± is one standard deviation over the "
      "subjects.";
  return context.drawn(plate);
}

}  // namespace mien
