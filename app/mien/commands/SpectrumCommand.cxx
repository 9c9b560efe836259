#include <CLI/CLI.hpp>
#include <memory>

#include "Arguments.h"
#include "Command.h"
#include "CsvText.h"
#include "FaceStateText.h"
#include "Failure.h"
#include "MeasureReports.h"
#include "PipelineErrors.h"
#include "SpectrumFigure.h"
#include "TableRows.h"
#include "vtkNew.h"
#include "vtkPDEModeFilter.h"
#include "vtkTable.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct SpectrumCommandOptions {
  MeasuredFace face;
  ReportOptions report;
  std::string toleranceText;
};

/// The mode's number, where it has one.
json modeName(const std::string& name) {
  if (name == "remainder") return name;
  return parseWholeNumber("mode", name);
}

/// The row of a mode as the JSON has it: n, then the measures.
json modeObject(const json& row) {
  json object;
  for (const auto& item : row.items())
    if (item.key() == "mode")
      object["n"] = modeName(item.value());
    else
      object[item.key()] = item.value();
  return object;
}

ModeMeasures measuresOf(const json& row) {
  const auto number = [&](const char* key) { return row[key].is_null() ? 0.0 : row[key].get<double>(); };
  ModeMeasures measures;
  measures.mode = row["mode"];
  measures.rms = number("rms_mm");
  measures.max = number("max_mm");
  measures.energyShare = number("energy_share");
  measures.cumulativeError = number("cumulative_rms_error_mm");
  return measures;
}

void findSmallestCount(vtkPDEModeFilter* filter, const std::string& scheme, double tolerance, json& about,
                       Report& report) {
  const int count = filter->FindNumberOfModes(tolerance);
  if (count < 0) return;  // the error is among those observed
  about["tolerance_mm"] = tolerance;
  about["smallest_harmonics"] = count;
  report.remarks.push_back(scheme + ": modes 0 .. " + std::to_string(count) + " come within " +
                           shortestText(tolerance) +
                           " mm RMS of the surface of all modes; smallest N = " + std::to_string(count));
}

SchemeSpectrum measureScheme(const MeasuredFace& face, const std::string& scheme,
                             const std::optional<double>& tolerance, Report& report) {
  vtkNew<vtkPDEModeFilter> filter;
  PipelineErrors errors;
  errors.observe(filter);
  face.connect(filter, scheme);
  filter->SetResolution(face.state().rows, face.state().columns);
  filter->SetUniformRows(face.state().uniformRows);
  filter->Update();
  json about = face.description(scheme);
  about["harmonics"] = about["modes"];
  if (tolerance && errors.first().empty()) findSmallestCount(filter, scheme, *tolerance, about, report);
  if (!errors.first().empty()) throw ValueFailure(errors.first());
  SchemeSpectrum spectrum{scheme, {}};
  about["modes"] = json::array();
  for (const json& row : tableRows(filter->GetSpectrum())) {
    about["modes"].push_back(modeObject(row));
    report.rows.push_back({{"scheme", scheme}});
    report.rows.back().update(modeObject(row));
    spectrum.modes.push_back(measuresOf(row));
  }
  report.json["schemes"].push_back(about);
  return spectrum;
}

void run(SpectrumCommandOptions& options) {
  options.report.check();
  std::optional<double> tolerance;  // mm
  if (!options.toleranceText.empty()) tolerance = parseMillimetres("--tolerance", options.toleranceText);
  options.face.update();
  options.report.deliver(spectrumReport(options.face, tolerance), writeFaceState(options.face.state()));
}

}  // namespace

Report spectrumReport(const MeasuredFace& face, const std::optional<double>& tolerance) {
  Report report;
  report.rows = json::array();
  std::vector<SchemeSpectrum> spectra;
  for (const std::string& scheme : face.schemes()) spectra.push_back(measureScheme(face, scheme, tolerance, report));
  if (spectra.size() == 1) report.json = json(report.json["schemes"][0]);
  const FaceState& state = face.state();
  const std::string note =
      face.note() + "; " + std::to_string(state.rows) + " x " + std::to_string(state.columns) + " points";
  report.figure = [spectra, tolerance, note, remarks = report.remarks] {
    Figure figure = spectrumFigure(spectra, tolerance);
    for (const std::string& remark : remarks) figure.caption += " " + remark + ".";
    figure.note = note;
    return figure;
  };
  return report;
}

void addSpectrumCommand(CLI::App& program) {
  const auto options = std::make_shared<SpectrumCommandOptions>();
  CLI::App* command = program.add_subcommand("spectrum", "Measure what each Fourier mode adds to a face");
  options->report.addTo(*command);
  command->add_option("--tolerance", options->toleranceText,
                      "Names the smallest N whose modes come that near to the surface, mm, such as 0.1mm");
  options->face.addTo(*command);
  command->footer(
      "Example: mien spectrum -N 12 --tolerance 0.1mm -o spectrum.pdf\n"
      "RMS and largest length of each mode's contribution (mm), its share of the energy with the centroid removed, and "
      "the RMS\n"
      "of what the sum of the modes so far still lacks; the remainder is all harmonics above N together.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
