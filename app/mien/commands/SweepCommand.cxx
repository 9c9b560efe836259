#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "Arguments.h"
#include "Command.h"
#include "CsvText.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "MeasureReports.h"
#include "MeshFile.h"
#include "NumberRange.h"
#include "PipelineErrors.h"
#include "SweepFigure.h"
#include "TableRows.h"
#include "WatchedUpdate.h"
#include "vtkNew.h"
#include "vtkPDEParameterSweep.h"
#include "vtkTable.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct SweepCommandOptions {
  MeasuredFace face;
  ReportOptions report;
  SweepChoice choice;
};

void setOptions(const MeasuredFace& face, const SweepChoice& choice, vtkPDEParameterSweep* sweep) {
  std::vector<double> values;
  const std::string fault = parseNumberRange(choice.range, values);
  if (!fault.empty()) throw ValueFailure("-a: " + fault);
  sweep->SetSmoothingValues(values);
  sweep->SetReferenceSmoothing(parseNumber("--reference-a", choice.referenceSmoothing));
  sweep->SetResolution(face.state().rows, face.state().columns);
  for (const std::string& scheme : face.schemes()) sweep->AddScheme(scheme);
}

/// The row as a record of filters/core, for the figure.
SweepRecord recordOf(const json& row) {
  SweepRecord record;
  record.scheme = row["scheme"];
  record.smoothing = row["a"];
  for (const std::string& name : sweepMeasureNames()) {
    const bool known = row.contains(name) && !row[name].is_null();
    record.values.push_back(known ? row[name].get<double>() : std::numeric_limits<double>::quiet_NaN());
  }
  record.reason = row["reason"];
  return record;
}

json withoutReason(json row) {
  row.erase("reason");
  return row;
}

/// A sample of the JSON: without a reason there is none.
json sampleOf(json row) {
  if (row["reason"].get<std::string>().empty()) row.erase("reason");
  for (const char* const count : {"folded_cells", "folded_cells_on_seams"})
    if (row[count].is_number()) row[count] = static_cast<long long>(row[count].get<double>());
  return row;
}

std::map<std::string, double> describeBreakdowns(const MeasuredFace& face, vtkPDEParameterSweep* sweep,
                                                 Report& report) {
  std::map<std::string, double> breakdowns;
  report.json["breakdowns"] = json::array();
  for (const std::string& scheme : face.schemes()) {
    const double a = sweep->GetBreakdown(scheme);
    const std::string reason = sweep->GetBreakdownReason(scheme);
    report.json["breakdowns"].push_back(
        {{"scheme", scheme}, {"a", std::isfinite(a) ? json(a) : json(nullptr)}, {"reason", reason}});
    if (std::isfinite(a)) breakdowns[scheme] = a;
    report.remarks.push_back(scheme + ": " +
                             (std::isfinite(a) ? "breaks down at a = " + readableNumber(a) + ": " + reason
                                               : "holds at every a of the sweep"));
  }
  return breakdowns;
}

Report reportOf(const MeasuredFace& face, const SweepChoice& choice, vtkPDEParameterSweep* sweep) {
  const FaceState& state = face.state();
  Report report;
  report.json = face.description(face.schemes().front());
  report.json.erase("a");
  report.json["scheme"] = face.schemes().size() == 1 ? json(face.schemes().front()) : json(face.schemes());
  report.json["reference_a"] = sweep->GetReferenceSmoothing();
  report.json["rows"] = state.rows;
  report.json["columns"] = state.columns;
  report.rows = json::array();
  std::vector<SweepRecord> records;
  for (const json& row : tableRows(sweep->GetOutput())) {
    records.push_back(recordOf(row));
    report.rows.push_back(row);
    report.readable.push_back(withoutReason(row));
    report.json["samples"].push_back(sampleOf(row));
  }
  const std::map<std::string, double> breakdowns = describeBreakdowns(face, sweep, report);
  const std::string note = face.note(false) + "; " + std::to_string(state.rows) + " × " +
                           std::to_string(state.columns) + " points" +
                           (choice.scan.empty() ? "" : "; distance to " + choice.scan);
  report.figure = [records, breakdowns, note, reference = sweep->GetReferenceSmoothing()] {
    Figure figure = sweepFigure(records, breakdowns, reference);
    figure.note = note;
    return figure;
  };
  return report;
}

void run(SweepCommandOptions& options) {
  options.report.check();
  options.face.update();
  options.report.deliver(sweepReport(options.face, options.choice), writeFaceState(options.face.state()));
}

}  // namespace

Report sweepReport(const MeasuredFace& face, const SweepChoice& choice) {
  vtkNew<vtkPDEParameterSweep> sweep;
  PipelineErrors errors;
  errors.observe(sweep);
  face.connect(sweep, face.schemes().front());
  setOptions(face, choice, sweep);
  if (!choice.scan.empty()) sweep->SetReferenceData(readMesh(choice.scan));
  updateWatched(sweep, "sweep");
  if (!errors.first().empty()) throw ValueFailure(errors.first());
  return reportOf(face, choice, sweep);
}

void addSweepCommand(CLI::App& program) {
  const auto options = std::make_shared<SweepCommandOptions>();
  CLI::App* command = program.add_subcommand("sweep", "Measure a face over the smoothing parameter a");
  options->report.addTo(*command);
  const SmoothingSweepOptions usual;
  options->face.setDefaultResolution(usual.rows, usual.columns);
  options->face.addWithoutSmoothing(*command);
  command->add_option("-a,--a,--smoothing", options->choice.range, "Values of a: 0.5,1,2 or 0.1:100:50log or 0.1:1:10")
      ->capture_default_str()
      ->group("Face");
  command->add_option("--reference-a", options->choice.referenceSmoothing, "The a that departures are measured from")
      ->capture_default_str();
  command->add_option("--reference", options->choice.scan, "Mesh that distances are measured to, such as a scan");
  command->footer(
      "Example: mien sweep --scheme all --a 0.1:100:50log -o sweep.csv -o sweep.svg\n"
      "Area, departure from the surface at the reference a, miss of the curves, Lebesgue constant, largest angle at a "
      "seam,\n"
      "folded cells, Willmore energy; markers above a chart show where a scheme breaks down,\n"
      "to 1 % on grids that are refined until it stays. Ctrl-C stops without output.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
