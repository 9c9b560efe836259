#include <algorithm>
#include <tuple>

#include "BreakdownSearch.h"
#include "CatalogueFigures.h"
#include "ChartPanel.h"
#include "CsvText.h"
#include "FaceScheme.h"
#include "FigureContext.h"
#include "FigurePanel.h"
#include "MeasureReports.h"
#include "PanelRow.h"
#include "TextTable.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

std::vector<std::string> allSchemes() {
  std::vector<std::string> names;
  for (const FaceScheme& scheme : faceSchemes()) names.push_back(scheme.name);
  return names;
}

constexpr double rounding = 1e-9;  // degrees: less is none

/// The digits that a search to 1 percent knows, and none less.
std::string breakdownText(const json& a) {
  return a.is_number() ? QString::number(a.get<double>(), 'g', 3).toStdString() : "holds";
}

std::string threeDigits(const json& value) {
  if (!value.is_number()) return "-";
  return value < rounding ? "0" : QString::number(value.get<double>(), 'g', 3).toStdString();
}

/// The chart without its own words, which the plate has. In one column it is lower, so that it fits a page.
PlatePanel bare(FigureContext& context, Figure chart) {
  constexpr double narrowShare = 0.84;
  chart.title.clear();
  chart.caption.clear();
  chart.note.clear();
  chart.labelled = context.settings().labelled;
  return figurePanel("", chart, context.innerWidth(), context.isNarrow() ? narrowShare : 1.0);
}

/// The largest angle of each seam, a column for each scheme.
TextTable largestAngles(const json& report, const std::vector<std::string>& schemes) {
  TextTable table;
  table.size = 6.0;
  table.close = true;
  table.columns.push_back({"Seam", 0.8});
  for (const std::string& scheme : schemes) table.columns.push_back({scheme, 1.0, true});
  const json& first = report["schemes"][0]["seams"];
  for (std::size_t seam = 0; seam < first.size(); ++seam) {
    table.rows.push_back({first[seam]["seam"].get<std::string>()});
    for (std::size_t i = 0; i < schemes.size(); ++i)
      table.rows.back().push_back(threeDigits(report["schemes"][i]["seams"][seam]["g1_max_deg"]));
  }
  return table;
}

/// Where each scheme breaks down, and why.
TextTable breakdownTable(const json& breakdowns) {
  TextTable table;
  table.close = true;
  table.columns = {{"Scheme", 0.8}, {"Breaks down at a", 0.9}, {"Because", 2.3}};
  for (const json& row : breakdowns)
    table.rows.push_back({row["scheme"].get<std::string>(), breakdownText(row["a"]), row["reason"].get<std::string>()});
  return table;
}

std::string gridText(int factor) {
  return std::to_string(factor * BreakdownSearch::rows) + " × " + std::to_string(factor * BreakdownSearch::columns);
}

/// The surface at a few values of a, the same scheme.
PlatePanel surfaceRow(FigureContext& context) {
  std::vector<PlatePanel> panels;
  for (const double a : {0.1, 1.0, 3.0, 10.0}) {
    FaceState state = context.state();
    state.surface.smoothing.fill(a);
    state.rows = 164;
    state.columns = 160;
    panels.push_back(
        context.facePanel("a = " + shortestText(a), state, SceneStyle(), context.innerWidth() / 4.0, faceShape));
  }
  PlatePanel row = panelRow("The surface, scheme " + context.state().surface.scheme, panels, context.innerWidth());
  if (context.settings().labelled) row.label = "(a)";
  return row;
}

}  // namespace

FigureDrawing drawContinuity(FigureContext& context) {
  MeasuredFace face;
  face.set(context.state(), allSchemes());
  const Report report = continuityReport(face, {});
  const Figure chart = report.figure();
  Plate plate;
  plate.columns = 1;
  plate.note = chart.note;
  plate.caption =
      "Angle between the normals of neighbouring patches along each seam, from the back of the head (v = 0) over the "
      "nose "
      "bridge (180 degrees), and its largest values; less than 1e-9 degrees, rounding, is given as 0.";
  plate.panels = {bare(context, chart), tablePanel("Largest angle, degrees", largestAngles(report.json, face.schemes()),
                                                   context.innerWidth())};
  return context.drawn(plate, false);
}

FigureDrawing drawSpectrum(FigureContext& context) {
  MeasuredFace face;
  FaceState all = context.state();
  all.surface.modes = context.neutralFace().curves.pointsPerCurve / 2;  // partial sums up to the whole
  face.set(all, {all.surface.scheme});
  return context.drawn(spectrumReport(face, 0.1).figure());
}

FigureDrawing drawSweep(FigureContext& context) {
  MeasuredFace face;
  FaceState state = context.state();
  const SmoothingSweepOptions usual;  // as mien sweep
  if (!context.settings().hasResolution) std::tie(state.rows, state.columns) = std::tie(usual.rows, usual.columns);
  face.set(state, allSchemes());
  const Report report = sweepReport(face, SweepChoice());
  Figure chart = report.figure();
  chart.firstLabel = 1;  // behind the row of faces
  Plate plate;
  plate.columns = 1;
  plate.caption = chart.caption + " The table's a are exact to 1 %: bisected, on grids from " + gridText(1) +
                  " points up to " + gridText(BreakdownSearch::mostRows / BreakdownSearch::rows) + " until they stay.";
  plate.note = chart.note;
  plate.panels = {surfaceRow(context), bare(context, chart),
                  tablePanel("", breakdownTable(report.json["breakdowns"]), context.innerWidth())};
  return context.drawn(plate, false);
}

}  // namespace mien
