#include <CLI/CLI.hpp>
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

struct Options {
  std::string input;
  std::vector<std::string> against;
  MarkerFileOptions reading;
  TableOutput output;
};

/// The tables to compare with: those given, else the compiled in ones that have deviations, which are means.
std::vector<std::string> candidates(const Options& options) {
  if (!options.against.empty()) return options.against;
  std::vector<std::string> names;
  for (const std::string& name : tableNames())
    if (namedTable(name)->deviations) names.push_back(name);
  return names;
}

std::vector<RecognitionScore> scoresOf(const Options& options, const TableInput& input,
                                       const std::vector<DeformationTable>& means, const FacialRegions& regions) {
  std::vector<RecognitionScore> scores;
  const std::string fault = input.markers ? recognise(samplesOf(*input.markers, regions), means, scores)
                                          : recognise(input.table, regions, means, scores);
  if (!fault.empty()) throw FileFailure(options.input + ": " + fault);
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
void reportStill(const Options& options) {
  Report report;
  report.rows = json::array();
  report.json = {{"file", options.input}, {"expression", nullptr}, {"intensity", 0.0}, {"scores", json::object()}};
  report.remarks = {"does not move: there is no expression to name"};
  options.output.writeRows(report.rows);
  options.output.print(report);
}

void run(const Options& options) {
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  const std::vector<std::string> names = candidates(options);
  std::vector<DeformationTable> means;
  for (const std::string& name : names) means.push_back(readTable(name));
  const TableInput input = readTableOrRecording(options.input, options.reading, regions);
  options.reading.refuseForTables(input.markers.has_value(), options.input);
  if (fittedDisplacement(input.table, regions) < leastRecognisedMovement) return reportStill(options);
  const std::vector<RecognitionScore> scores = scoresOf(options, input, means, regions);
  Report report;
  report.rows = json::array();
  json distances = json::object();
  for (const RecognitionScore& score : scores) {
    const std::string name = shortTableName(names[score.expression]);
    report.rows.push_back({{"expression", name}, {"distance", score.distance}, {"intensity", score.intensity}});
    distances[distances.contains(name) ? names[score.expression] : name] = score.distance;
  }
  const json regionList = decisive(scores, regions);
  report.json = {{"file", options.input},
                 {"expression", report.rows[0]["expression"]},
                 {"intensity", scores[0].intensity},
                 {"scores", distances},
                 {"scores_are", "distances in pupil units; the least is the nearest"},
                 {"decisive_regions", regionList}};
  report.remarks = {sentence(report.rows[0]["expression"], regionList)};
  options.output.writeRows(report.rows);
  options.output.print(report);
}

}  // namespace

void addFdtClassifyCommand(CLI::App& parent) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = parent.add_subcommand("classify", "Name the expression of a recording or a table");
  command->add_option("input", options->input, "Markers before and after, as for mien fdt fit, or a table")->required();
  command->add_option("--against", options->against, "Tables to compare with [the six means compiled in]");
  options->output.addTo(*command, "Scores to write, FILE.csv");
  options->reading.addTo(*command, true);
  command->footer(
      "Example: mien fdt classify anna.csv\n"
      "         mien fdt classify anna.csv --against joy.csv smile sadness --json\n"
      "Scores are distances: what a table leaves of the movement at its best intensity (0.5 to 1.5), pupil units. The "
      "least is\n"
      "the nearest.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
