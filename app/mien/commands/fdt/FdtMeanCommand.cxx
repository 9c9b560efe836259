#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "CsvText.h"
#include "FdtCommands.h"
#include "TableInput.h"
#include "TableOutput.h"
#include "TableRows.h"
#include "TableStatistics.h"

namespace mien {

namespace {

struct FdtMeanCommandOptions {
  std::vector<std::string> files;
  std::string comment;
  MarkerFileOptions reading;
  TableOutput output;
};

/// The mean of the standard deviations of a region's twelve coefficients.
double spread(const DeformationTable& mean, int region) {
  return mean.deviations->at(region - 1).mean();
}

nlohmann::ordered_json rowsOf(const DeformationTable& mean, const FacialRegions& regions) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Eigen::Vector2d& centre = regions.centre(region);
    const Eigen::Vector2d move = mean.maps[region - 1].apply(centre) - centre;
    const bool known = mean.knows(region);
    rows.push_back({{"region", std::to_string(region) + " " + regions.name(region)},
                    {"n", mean.counts->at(region - 1)},
                    {"centre_dx", known ? nlohmann::ordered_json(move.x()) : nullptr},
                    {"centre_dy", known ? nlohmann::ordered_json(move.y()) : nullptr}});
    if (mean.deviations)
      rows.back()["mean_sd"] = mean.hasRange(region) ? nlohmann::ordered_json(spread(mean, region)) : nullptr;
  }
  return rows;
}

std::string counted(std::size_t tables) {
  return std::to_string(tables) + (tables == 1 ? " table" : " tables");
}

/// Names the regions that some of the tables do not know, and how many do.
std::string describeGaps(const DeformationTable& mean, std::size_t tables) {
  std::string text;
  for (int region = 1; region <= FacialRegions::count; ++region)
    if (mean.counts->at(region - 1) < int(tables))
      text += (text.empty() ? "" : ", ") + std::to_string(region) + " (" + std::to_string(mean.counts->at(region - 1)) +
              ")";
  return text.empty() ? text
                      : "some have no markers in these regions, whose means are those of the others (n): " + text;
}

void run(const FdtMeanCommandOptions& options) {
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  std::vector<DeformationTable> tables;
  Report report;
  double sum = 0.0;
  int recordings = 0;
  report.json["files"] = nlohmann::ordered_json::array();
  for (const std::string& file : options.files) {
    const TableInput input = readTableOrRecording(file, options.reading, regions);
    tables.push_back(input.table);
    nlohmann::ordered_json about = {{"file", file}};
    if (input.markers) {
      about["rms"] = input.rms;
      sum += input.rms;
      ++recordings;
    }
    report.json["files"].push_back(about);
  }
  options.reading.refuseForTables(recordings > 0, "what was given");
  const DeformationTable mean = meanTable(tables);
  options.output.write(mean, options.comment.empty()
                                 ? "Mean of " + counted(tables.size()) +
                                       std::string(tables.size() > 1 ? " with standard deviations" : "") +
                                       ", pupil units; Mien " MIEN_VERSION
                                 : options.comment);
  report.json["tables"] = tables.size();
  if (recordings) report.json["mean_rms"] = sum / recordings;
  report.rows = rowsOf(mean, regions);
  report.json["regions"] = report.rows;
  report.remarks = {"mean of " + counted(tables.size()) +
                    (recordings ? "; mean RMS of the fits " + readableNumber(sum / recordings) + " pupil units" : "")};
  const std::string gaps = describeGaps(mean, tables.size());
  if (!gaps.empty()) {
    report.json["warning"] = gaps;
    std::cerr << "mien: " << gaps << "\n";
  }
  if (tables.size() == 1)
    report.remarks.push_back("one table has no spread: give several for standard deviations that mean something");
  options.output.print(report);
}

}  // namespace

void addFdtMeanCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtMeanCommandOptions>();
  CLI::App* command = parent.add_subcommand("mean", "Average tables, with standard deviations");
  command->add_option("files", options->files, "Tables, or recordings that are fitted on the way")->required();
  options->output.addTo(*command, "Table to write, FILE.csv", true);
  command->add_option("--comment", options->comment, "Text for the head of the file: what it is, and its source");
  options->reading.addTo(*command, true);
  command->footer(
      "Example: mien fdt mean subject*_joy.csv -o joy.csv\n"
      "Standard deviations are those of a sample (n - 1). Regions without markers in a recording are left out of the "
      "mean; n says how many remain. mien fdt check tells what lies outside mean +- sd.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
