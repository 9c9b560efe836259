#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "Failure.h"
#include "FdtCommands.h"
#include "NamedTables.h"
#include "TableDeformation.h"
#include "TableInput.h"
#include "TableOutput.h"
#include "TableRecognition.h"
#include "TableRows.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct FdtClassifyCommandOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> against;
  MarkerFileOptions reading;
  TableOutput output;
};

/// The tables to compare with: those given, else the compiled in ones that have deviations, which are means.
std::vector<std::string> candidates(const FdtClassifyCommandOptions& options) {
  std::vector<std::string> names = options.against;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::find(names.begin(), names.begin() + i, names[i]) != names.begin() + i)
      throw ValueFailure("--against names " + names[i] + " twice; the scores need tables that differ");
  if (!names.empty()) return names;
  for (const std::string& name : tableNames())
    if (namedTable(name)->deviations) names.push_back(name);
  return names;
}

/// What inputs are compared with.
struct Candidates {
  std::vector<std::string> names;
  std::vector<DeformationTable> means;
  FacialRegions regions;

  explicit Candidates(const FdtClassifyCommandOptions& options)
      : names(candidates(options)), regions(options.reading.regions()) {
    for (const std::string& name : names) means.push_back(readTable(name));
  }
};

std::vector<RecognitionScore> scoresOf(const TableInput& input, const Candidates& with) {
  std::vector<RecognitionScore> scores;
  const std::string fault = input.markers ? recognise(samplesOf(*input.markers, with.regions), with.means, scores)
                                          : recognise(input.table, with.regions, with.means, scores);
  if (!fault.empty()) throw FileFailure(input.name + ": " + fault);
  return scores;
}

json decisive(const std::vector<RecognitionScore>& scores, const FacialRegions& regions) {
  json list = json::array();
  if (scores.size() < 2) return list;
  for (const int region : decisiveRegions(scores))
    list.push_back({{"region", region},
                    {"name", regions.name(region)},
                    {"nearest", scores[0].regions[region - 1]},
                    {"second", scores[1].regions[region - 1]}});
  return list;
}

std::string sentence(const std::string& name, const json& regions) {
  std::string text = "nearest: " + name;
  for (const json& region : regions)
    text += (&region == &regions.front() ? "; most decisive: " : ", ") + std::to_string(region["region"].get<int>()) +
            " " + region["name"].get<std::string>();
  return text;
}

/// Without movement every expression is as far away as it is strong, and the weakest would win.
Report reportStill(const std::string& file) {
  Report report;
  report.rows = json::array();
  report.json = {{"file", file}, {"expression", nullptr}, {"intensity", 0.0}, {"scores", json::object()}};
  report.remarks = {"does not move: there is no expression to name"};
  return report;
}

Report classify(const std::string& file, const FdtClassifyCommandOptions& options, const Candidates& with) {
  const TableInput input = readTableOrRecording(file, options.reading, with.regions);
  options.reading.refuseForTables(input.markers.has_value(), file);
  if (fittedDisplacement(input.table, with.regions) < leastRecognisedMovement) return reportStill(file);
  const std::vector<RecognitionScore> scores = scoresOf(input, with);
  Report report;
  report.rows = json::array();
  json distances = json::object();
  for (const RecognitionScore& score : scores) {
    const std::string full = with.names[score.expression], name = shortTableName(full);
    report.rows.push_back({{"expression", name}, {"distance", score.distance}, {"intensity", score.intensity}});
    distances[distances.contains(name) ? full : name] = score.distance;
  }
  const json regionList = decisive(scores, with.regions);
  report.json = {{"file", file},
                 {"expression", report.rows[0]["expression"]},
                 {"intensity", scores[0].intensity},
                 {"scores", distances},
                 {"scores_are", "distances in pupil units; the least is the nearest"},
                 {"decisive_regions", regionList}};
  report.remarks = {sentence(report.rows[0]["expression"], regionList)};
  return report;
}

/// A row for each input: the nearest expression and the one after it.
Report classifyAll(const FdtClassifyCommandOptions& options, const Candidates& with) {
  Report all;
  all.rows = all.json = json::array();
  for (const std::string& file : options.inputs) {
    const Report one = classify(file, options, with);
    all.json.push_back(one.json);
    const auto cell = [&](std::size_t row, const char* name) {
      return one.rows.size() > row ? one.rows[row][name] : json(nullptr);
    };
    all.rows.push_back({{"file", file},
                        {"expression", cell(0, "expression")},
                        {"distance", cell(0, "distance")},
                        {"intensity", cell(0, "intensity")},
                        {"second", cell(1, "expression")},
                        {"second_distance", cell(1, "distance")}});
  }
  return all;
}

void run(const FdtClassifyCommandOptions& options) {
  options.output.check();
  const Candidates with(options);
  const Report report =
      options.inputs.size() == 1 ? classify(options.inputs.front(), options, with) : classifyAll(options, with);
  options.output.writeRows(report.rows);
  options.output.print(report);
}

}  // namespace

void addFdtClassifyCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtClassifyCommandOptions>();
  CLI::App* command = parent.add_subcommand("classify", "Name the expression of a recording or a table");
  command
      ->add_option("inputs", options->inputs,
                   "Markers before and after, as for mien fdt fit, or tables; several give a row each")
      ->required();
  command->add_option("--against", options->against, "Tables to compare with [the six means compiled in]");
  options->output.addTo(*command, "Scores to write, FILE.csv");
  options->reading.addTo(*command, true);
  command->footer(
      "Example: mien fdt classify anna.csv\n"
      "         mien fdt classify anna.csv --against joy.csv smile sadness --json\n"
      "         mien fdt classify subject*.csv -o nearest.csv\n"
      "Scores are distances: what a table leaves of the movement at its best intensity (0.5 to 1.5), pupil units. The "
      "least is\n"
      "the nearest. With several inputs --json gives an array.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
