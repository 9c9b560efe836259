#include <algorithm>
#include <cmath>

#include "AnimationData.h"
#include "CatalogueFigures.h"
#include "CsvText.h"
#include "FigureContext.h"
#include "TextTable.h"

namespace mien {

namespace {

constexpr const char* noBreak = "\u00a0";  // between a FAP and its value

/// "31: 150, 32: 150": the FAPs of an action with their values.
std::string valueText(const FacialAction& action) {
  std::string text;
  std::vector<std::pair<int, double>> values = action.values;
  std::sort(values.begin(), values.end());
  for (const auto& [fap, value] : values)
    text += (text.empty() ? "" : ", ") + std::to_string(fap) + ":" + noBreak + (value < 0.0 ? "−" : "") +
            shortestText(std::abs(value));
  return text;
}

/// @param narrow  name and definition in one column
std::vector<std::vector<std::string>> rowsOf(const ExpressionProfile& expression, bool narrow) {
  std::vector<std::vector<std::string>> rows;
  for (const FacialAction& action : expression.actions) {
    const bool first = rows.empty();
    std::vector<std::string> cells = {first ? expression.name : ""};
    if (!narrow) cells.push_back(first ? expression.definition : "");
    cells.push_back(action.name);
    cells.push_back(valueText(action));
    rows.push_back(cells);
  }
  return rows;
}

/// "joy: the brows rest; .. sadness: .."
std::string definitions() {
  std::string text;
  for (const ExpressionProfile& expression : defaultExpressions().expressions())
    text += " " + expression.name + ": " + expression.definition + ".";
  return text;
}

}  // namespace

FigureDrawing drawExpressionTable(FigureContext& context) {
  TextTable table;
  const bool narrow = context.isNarrow();
  table.close = narrow;
  table.columns = {{"Expression", 0.8}, {"Definition", 2.2}, {"Facial action", 1.5}, {"FAP: value", 2.2}};
  if (narrow) table.columns.erase(table.columns.begin() + 1);
  for (const ExpressionProfile& expression : defaultExpressions().expressions())
    for (const std::vector<std::string>& row : rowsOf(expression, narrow)) table.rows.push_back(row);
  Plate plate;
  plate.columns = 1;
  plate.panels = {tablePanel("", table, context.innerWidth())};
  plate.caption =
      "FAP numbers of MPEG-4 (ISO/IEC 14496-2) and their values at full intensity in FAP units: 1/1024 of a distance "
      "between features of the face.";
  if (narrow) plate.caption += definitions();
  return context.drawn(plate);
}

}  // namespace mien
