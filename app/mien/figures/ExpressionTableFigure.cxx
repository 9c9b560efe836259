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
  for (const auto& [fap, value] : action.values)
    text += (text.empty() ? "" : ", ") + std::to_string(fap) + ":" + noBreak + shortestText(value);
  return text;
}

std::vector<std::vector<std::string>> rowsOf(const ExpressionProfile& expression) {
  std::vector<std::vector<std::string>> rows;
  for (const FacialAction& action : expression.actions) {
    const bool first = rows.empty();
    rows.push_back({first ? expression.name : "", first ? expression.definition : "", action.name, valueText(action)});
  }
  return rows;
}

}  // namespace

FigureDrawing drawExpressionTable(FigureContext& context) {
  TextTable table;
  table.columns = {{"Expression", 0.8}, {"Definition", 2.2}, {"Facial action", 1.5}, {"FAP: value", 2.2}};
  for (const ExpressionProfile& expression : defaultExpressions().expressions())
    for (const std::vector<std::string>& row : rowsOf(expression)) table.rows.push_back(row);
  Plate plate;
  plate.columns = 1;
  plate.panels = {tablePanel("", table, context.innerWidth())};
  plate.caption =
      "Values at full intensity in FAP units (MPEG-4, ISO/IEC 14496-2); each FAP's unit is a 1024th of a "
      "distance of this face.";
  return context.drawn(plate);
}

}  // namespace mien
