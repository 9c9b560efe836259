#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "Arguments.h"
#include "Command.h"
#include "FaceLayout.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "InfluenceFigure.h"
#include "MeasuredFace.h"
#include "PipelineErrors.h"
#include "ReportOptions.h"
#include "SurfaceFile.h"
#include "TableRows.h"
#include "vtkNew.h"
#include "vtkPDEInfluenceFilter.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct InfluenceCommandOptions {
  MeasuredFace face;
  ReportOptions report{{"vts"}};
  std::string curve = "C10", point, direction = "0,0,1";
};

json finite(double value) {
  return std::isfinite(value) ? json(value) : json(nullptr);
}

void setOptions(const InfluenceCommandOptions& options, vtkPDEInfluenceFilter* filter) {
  const std::vector<std::string> parts = splitText(options.direction, ',');
  if (parts.size() != 3)
    throw ValueFailure("--direction '" + options.direction + "' is no vector; write three numbers as 0,0,1");
  filter->SetDirection(parseNumber("--direction", parts[0]), parseNumber("--direction", parts[1]),
                       parseNumber("--direction", parts[2]));
  filter->SetCurve(options.curve);
  if (!options.point.empty()) filter->SetPoint(parseWholeNumber("--point", options.point));
  if (!options.point.empty() && filter->GetPoint() < 0)
    throw ValueFailure("--point " + options.point + " is none; points count from 0");
  filter->SetResolution(options.face.state().rows, options.face.state().columns);
}

/// "C10 moves" or "point 3 of C10 moves".
std::string movement(const InfluenceCommandOptions& options) {
  return (options.point.empty() ? "" : "point " + options.point + " of ") + options.curve + " moves";
}

/// Position of the moved curve, 1 at C1.
double movedPosition(const std::string& curve) {
  for (int index = 0; index < FaceLayout::curveCount; ++index)
    if (FaceLayout::curveName(index) == curve)
      return index < FaceLayout::lowerLip ? index + 1.0 : static_cast<double>(index);
  return 1.0;
}

InfluenceProfile measureScheme(const InfluenceCommandOptions& options, const std::string& scheme, Report& report) {
  vtkNew<vtkPDEInfluenceFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  options.face.connect(filter, scheme);
  setOptions(options, filter);
  filter->Update();
  if (!errors.first().empty()) throw ValueFailure(errors.first());
  json about = options.face.description(scheme);
  about["half_width_above_curves"] = finite(filter->GetHalfWidthAbove());
  about["half_width_below_curves"] = finite(filter->GetHalfWidthBelow());
  const json rows = tableRows(filter->GetProfile());
  about["profile"] = rows;
  report.json["schemes"].push_back(about);
  InfluenceProfile profile{scheme, {}, {}};
  for (const json& row : rows) {
    report.rows.push_back({{"scheme", scheme}});
    report.rows.back().update(row);
    profile.curve.push_back(row["curve"]);
    profile.influence.push_back(row["influence_max"].is_null() ? std::nan("") : row["influence_max"].get<double>());
  }
  const auto text = [](const json& width) { return width.is_null() ? "none" : readableNumber(width) + " curves"; };
  report.remarks.push_back(scheme + ": half-width above " + text(about["half_width_above_curves"]) + ", below " +
                           text(about["half_width_below_curves"]));
  for (const std::string& name : options.report.outputs("vts")) writeSurface(filter->GetOutput(), name);
  return profile;
}

void run(InfluenceCommandOptions& options) {
  options.report.check();
  options.face.update();
  if (options.face.schemes().size() > 1 && !options.report.outputs("vts").empty())
    throw ValueFailure("a .vts file holds the face in one scheme; choose one with --scheme");
  Report report;
  report.rows = json::array();
  std::vector<InfluenceProfile> profiles;
  for (const std::string& scheme : options.face.schemes()) profiles.push_back(measureScheme(options, scheme, report));
  if (profiles.size() == 1) report.json = json(report.json["schemes"][0]);
  report.json["curve"] = options.curve;
  if (!options.point.empty()) report.json["point"] = parseWholeNumber("--point", options.point);
  report.figure = [&] {
    Figure figure = influenceFigure(profiles, movedPosition(options.curve), movement(options));
    figure.note = options.face.note() + "; direction " + options.direction;
    return figure;
  };
  options.report.deliver(report, writeFaceState(options.face.state()));
}

}  // namespace

void addInfluenceCommand(CLI::App& program) {
  const auto options = std::make_shared<InfluenceCommandOptions>();
  options->face.setDefaultResolution(164, 80);  // six rows between curves: the profile is smooth
  CLI::App* command =
      program.add_subcommand("influence", "Measure how the effect of one curve's move fades over a face");
  options->report.addTo(*command);
  command->add_option("--curve", options->curve, "The curve that moves: C1 .. C22, C22', C23 .. C28")
      ->capture_default_str();
  command->add_option("--point", options->point, "The one point of it that moves, from 0 [the whole curve]");
  command->add_option("--direction", options->direction, "Where to, x,y,z")->capture_default_str();
  options->face.addTo(*command);
  command->footer(
      "Example: mien influence --curve C10 --scheme all -o influence.svg\n"
      "The largest move of each row of the surface per mm, and how many curves away it has fallen to half "
      "(half-width). A .vts\n"
      "file is the face with the point array Influence (mm per mm).");
  command->callback([options] { run(*options); });
}

}  // namespace mien
