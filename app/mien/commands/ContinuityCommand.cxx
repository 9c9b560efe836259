#include <CLI/CLI.hpp>
#include <map>
#include <memory>

#include "Command.h"
#include "ContinuityFigure.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "MeasureReports.h"
#include "PipelineErrors.h"
#include "PolyDataFile.h"
#include "TableRows.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPatchContinuityFilter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct ContinuityCommandOptions {
  MeasuredFace face;
  ReportOptions report{{"vtp"}};
  ContinuityChoice choice;
};

/// What a chart shows: the array of the filter and its axis.
struct Measure {
  const char* array;
  const char* title;
  const char* unit;
};

const std::map<std::string, Measure> measures = {{"g0", {"G0", "gap", "mm"}},
                                                 {"g1", {"G1", "angle", "degrees"}},
                                                 {"c1", {"C1", "relative jump of S_u", ""}},
                                                 {"g2", {"G2", "jump of curvature", "1/mm"}},
                                                 {"c2", {"C2", "relative jump of S_uu", ""}}};

const std::string frontalPrefix = "frontal_";

/// The columns of a row with or without the prefix, in an object without it.
json part(const json& row, bool frontal) {
  json object = json::object();
  for (const auto& item : row.items()) {
    const bool isFrontal = item.key().rfind(frontalPrefix, 0) == 0;
    if (item.key() == "seam" || isFrontal == frontal)
      object[isFrontal ? item.key().substr(frontalPrefix.size()) : item.key()] = item.value();
  }
  return object;
}

json withoutSeam(json object) {
  object.erase("seam");
  return object;
}

/// seams[], all: the measures over all of them, frontal: the same where z > 50 mm.
void describe(const json& rows, json& about) {
  json seams = json::array(), frontal = json::array();
  for (const json& row : rows) {
    const bool isTotal = row["seam"] == "all";
    if (isTotal) about["all"] = withoutSeam(part(row, false));
    if (isTotal) about["frontal"] = withoutSeam(part(row, true));
    if (!isTotal) seams.push_back(part(row, false));
    if (!isTotal) frontal.push_back(part(row, true));
  }
  about["seams"] = seams;
  about["frontal"]["seams"] = frontal;
}

std::vector<SeamProfile> profiles(vtkPolyData* seams, const std::string& scheme, const Measure& measure) {
  std::vector<SeamProfile> all;
  vtkDataArray* v = seams->GetPointData()->GetArray("V");
  vtkDataArray* values = seams->GetPointData()->GetArray(measure.array);
  vtkAbstractArray* names = seams->GetCellData()->GetAbstractArray("SeamName");
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < seams->GetNumberOfCells(); ++cell) {
    SeamProfile profile{scheme, names->GetVariantValue(cell).ToString(), {}, {}};
    seams->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i + 1 < points->GetNumberOfIds(); ++i) {
      profile.v.push_back(vtkMath::DegreesFromRadians(v->GetTuple1(points->GetId(i))));
      profile.value.push_back(values->GetTuple1(points->GetId(i)));
    }
    profile.v.push_back(profile.v.front() + 360.0);  // once around
    profile.value.push_back(profile.value.front());
    all.push_back(profile);
  }
  return all;
}

json withScheme(const std::string& scheme, const json& row) {
  json object = {{"scheme", scheme}};
  object.update(row);
  return object;
}

/// One scheme's part of the report.
void measureScheme(const MeasuredFace& face, const std::string& scheme, const ContinuityChoice& choice,
                   const ReportOptions& files, Report& report, std::vector<SeamProfile>& drawn) {
  vtkNew<vtkPatchContinuityFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  face.connect(filter, scheme);
  filter->SetNumberOfSamples(choice.samples);
  filter->Update();
  if (!errors.first().empty()) throw ValueFailure(errors.first());
  const json rows = tableRows(filter->GetSummary());
  for (const json& row : rows) {
    report.rows.push_back(withScheme(scheme, row));
    report.readable.push_back(withScheme(scheme, part(row, false)));
  }
  report.readable.push_back(withScheme(scheme, part(rows.back(), true)));
  report.readable.back()["seam"] = "frontal";
  json about = face.description(scheme);
  describe(rows, about);
  report.json["schemes"].push_back(about);
  const std::vector<SeamProfile> own = profiles(filter->GetOutput(), scheme, measures.at(choice.measure));
  drawn.insert(drawn.end(), own.begin(), own.end());
  for (const std::string& name : files.outputs("vtp")) writePolyData(filter->GetOutput(), name);
}

void run(ContinuityCommandOptions& options) {
  options.report.check();
  options.face.update();
  if (options.face.schemes().size() > 1 && !options.report.outputs("vtp").empty())
    throw ValueFailure("a .vtp file holds the seams of one scheme; choose one with --scheme");
  options.report.deliver(continuityReport(options.face, options.choice, options.report),
                         writeFaceState(options.face.state()));
}

}  // namespace

Report continuityReport(const MeasuredFace& face, const ContinuityChoice& choice, const ReportOptions& files) {
  Report report;
  report.rows = json::array();
  std::vector<SeamProfile> drawn;
  for (const std::string& scheme : face.schemes()) measureScheme(face, scheme, choice, files, report, drawn);
  if (face.schemes().size() == 1) report.json = json(report.json["schemes"][0]);
  const std::string note = face.note() + "; " + std::to_string(choice.samples) + " samples per seam";
  report.figure = [drawn, note, measure = measures.at(choice.measure)] {
    Figure figure = continuityFigure(drawn, {measure.title, measure.unit, ChartAxis::Scale::Linear});
    figure.note = note;
    return figure;
  };
  return report;
}

void addContinuityCommand(CLI::App& program) {
  const auto options = std::make_shared<ContinuityCommandOptions>();
  CLI::App* command = program.add_subcommand("continuity", "Measure how smoothly the patches of a face meet");
  options->report.addTo(*command);
  command->add_option("--samples", options->choice.samples, "Per seam")
      ->capture_default_str()
      ->check(CLI::Range(3, 20000));
  command->add_option("--measure", options->choice.measure, "In the chart: g0, g1, c1, g2, c2")
      ->capture_default_str()
      ->check(CLI::IsMember(measures));
  options->face.addTo(*command);
  command->footer(
      "Example: mien continuity --scheme all -o seams.csv -o seams.svg\n"
      "Gap G0 (mm), angle between normals G1 (degrees), jump of S_u relative to its mean C1, jump of the curvature "
      "across the\n"
      "seam G2 (1/mm), jump of S_uu relative to its mean C2, measured from both sides; frontal: z > 50 mm. A .vtp file "
      "has\n"
      "the seams as lines with these as point arrays.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
