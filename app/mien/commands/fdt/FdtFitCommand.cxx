#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "Failure.h"
#include "FdtCommands.h"
#include "FittedTable.h"
#include "MeshFile.h"
#include "OutputFile.h"
#include "TableOutput.h"
#include "TableRows.h"
#include "vtkPointSet.h"

namespace mien {

namespace {

struct FdtFitCommandOptions {
  std::string recording, neutral, expression, landmarks;
  MarkerFileOptions reading;
  TableOutput output;
  bool strict = false;

  std::string source() const { return recording.empty() ? neutral + ", " + expression : recording; }
};

void check(const FdtFitCommandOptions& options) {
  const bool pair = !options.neutral.empty() && !options.expression.empty();
  if (options.recording.empty() != pair || (!options.recording.empty() && !options.neutral.empty()))
    throw ValueFailure("give one recording RECORDING.csv, or a face before and after with --neutral and --expression");
  if (pair && (fileEnding(options.neutral) == "csv") != (fileEnding(options.expression) == "csv"))
    throw ValueFailure("--neutral and --expression are a marker file and a surface; give two of one kind");
  if (pair && fileEnding(options.neutral) != "csv" && options.reading.turnsAxes())
    throw ValueFailure("--y-down and --mirrored are for marker files; surfaces have y up and x to the subject's left");
  if (!options.landmarks.empty() && (!pair || fileEnding(options.neutral) == "csv"))
    throw ValueFailure("--landmarks is for surfaces; markers are told by their names");
}

FittedTable fitPair(const FdtFitCommandOptions& options, const FacialRegions& regions) {
  if (fileEnding(options.neutral) != "csv") {
    const auto before = readMesh(options.neutral), after = readMesh(options.expression);
    return fitSurfaces(vtkPointSet::SafeDownCast(before), vtkPointSet::SafeDownCast(after), options.reading,
                       options.landmarks, options.strict, options.source());
  }
  MarkerTable markers;
  const std::string fault =
      markers.join(readPoints(options.neutral, options.reading), readPoints(options.expression, options.reading),
                   options.reading.markers(), {options.neutral, options.expression});
  if (!fault.empty()) throw FileFailure(fault);
  takeOutGivenPupils(markers, options.reading, options.source());
  return fitMarkers(markers, regions, options.strict, options.source());
}

void run(const FdtFitCommandOptions& options) {
  check(options);
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  const FittedTable fitted = options.recording.empty() ? fitPair(options, regions)
                                                       : fitMarkers(readRecording(options.recording, options.reading),
                                                                    regions, options.strict, options.recording);
  if (!fitted.warning.empty()) std::cerr << "mien: " << options.source() << ": " << fitted.warning << "\n";
  if (fitted.table.largestDisplacement < 1e-6)
    std::cerr << "mien: " << options.source() << ": nothing moves between the two states; is it the same file twice?\n";
  options.output.write(fitted.table, "Fitted to " + options.source() + ", RMS " + readableNumber(fitted.rms) +
                                         " pupil units; Mien " MIEN_VERSION);
  Report report;
  report.json = {{"file", options.source()}};
  report.json.update(fitted.description(regions));
  report.rows = fitted.rows(regions);
  report.remarks = {"RMS " + readableNumber(fitted.rms) +
                    " pupil units; rms and displacements of the regions' centres likewise"};
  if (!fitted.missing.empty())
    report.remarks.push_back(std::to_string(fitted.missing.size()) + " markers were not seen in both states");
  options.output.print(report);
}

}  // namespace

void addFdtFitCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtFitCommandOptions>();
  CLI::App* command = parent.add_subcommand("fit", "Fit a table to a face before and after");
  command->add_option("recording", options->recording,
                      "Markers before and after, FILE.csv: marker, neutral_x, neutral_y, expression_x, expression_y, "
                      "optionally neutral_z, expression_z, region");
  command->add_option("--neutral", options->neutral,
                      "In its place the face before: FILE.csv with marker, x, y, optionally z, region; or a surface "
                      ".ply .obj .stl .off .vtp .vts");
  command->add_option("--expression", options->expression,
                      "The face after: the same markers, or a surface with the same points in the same order");
  options->output.addTo(*command, "Table to write, FILE.csv");
  command->add_flag("--strict", options->strict, "A region with no point or fewer than 6 independent ones is an error");
  options->reading.addTo(*command, true);
  command
      ->add_option("--landmarks", options->landmarks,
                   "68 landmarks of surfaces, FILE.csv by vertex: for the pupils and to tell lips and lids apart")
      ->group("Reading faces");
  command->footer(
      "Example: mien fdt fit anna_joy.csv -o joy.csv\n"
      "         mien fdt fit --neutral before.csv --expression after.csv --y-down --pupils eyeL,eyeR -o smile.csv\n"
      "         mien fdt fit --neutral anna.ply --expression anna_joy.ply --landmarks anna68.csv --json\n"
      "Regions without markers do not move, as the forehead of the 68 landmarks; a warning names them.\n"
      "Blank cells are markers that were not seen. Markers named landmark00 .. landmark67 (Multi-PIE) tell upper from "
      "lower lips.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
