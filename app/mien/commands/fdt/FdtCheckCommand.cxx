#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "Failure.h"
#include "FdtCommands.h"
#include "TableInput.h"
#include "TableOutput.h"
#include "TableStatistics.h"

namespace mien {

namespace {

using json = nlohmann::ordered_json;

struct FdtCheckCommandOptions {
  std::string fit, against;
  MarkerFileOptions reading;
  TableOutput output;
};

json rowOf(int index, const DeformationTable& fit, const DeformationTable& mean) {
  const int region = index / 12, row = index % 12 / 6, column = index % 6;
  const double value = fit.maps[region].coefficients(row, column);
  const double expected = mean.maps[region].coefficients(row, column);
  const double deviation = mean.deviations->at(region)(row, column);
  return {{"region", region + 1}, {"coefficient", (row ? "b" : "a") + std::to_string(column + 1)},
          {"value", value},       {"mean", expected},
          {"sd", deviation},      {"sds", deviation > 0.0 ? json((value - expected) / deviation) : json(nullptr)}};
}

int comparedCoefficients(const DeformationTable& fit, const DeformationTable& mean) {
  int regions = 0;
  for (int region = 1; region <= FacialRegions::count; ++region) regions += isCompared(fit, mean, region);
  return 12 * regions;
}

void run(const FdtCheckCommandOptions& options) {
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  const DeformationTable mean = readTable(options.against);
  if (!mean.deviations)
    throw FileFailure(options.against +
                      ": it has no standard deviations (a1_sd ..); make a mean table with mien fdt mean");
  const TableInput input = readTableOrRecording(options.fit, options.reading, regions);
  options.reading.refuseForTables(input.markers.has_value(), options.fit, false);
  const int coefficientCount = comparedCoefficients(input.table, mean);
  const std::vector<int> outside = outsideRange(input.table, mean);
  Report report;
  report.rows = json::array();
  for (const int index : outside) report.rows.push_back(rowOf(index, input.table, mean));
  report.json = {{"fit", options.fit},
                 {"against", options.against},
                 {"outside", outside.size()},
                 {"coefficients", coefficientCount},
                 {"list", report.rows}};
  report.remarks = {std::to_string(outside.size()) + " of " + std::to_string(coefficientCount) +
                    " coefficients lie outside mean +- sd; of a subject like those of the mean at most about " +
                    std::to_string(static_cast<int>(std::round(0.3173 * coefficientCount))) + " do"};
  options.output.writeRows(report.rows);
  options.output.print(report);
}

}  // namespace

void addFdtCheckCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtCheckCommandOptions>();
  CLI::App* command = parent.add_subcommand("check", "List the coefficients outside mean +- standard deviation");
  command->add_option("fit", options->fit, "Table, or a recording that is fitted")->required();
  command->add_option("--against", options->against, "Mean table with standard deviations")->required();
  options->output.addTo(*command, "List to write, FILE.csv");
  options->reading.addTo(*command, true);
  command->footer(
      "Example: mien fdt check anna_joy.csv --against joy\n"
      "sds is how many standard deviations the value lies beside the mean; differences of less than 0.005 of the "
      "largest coefficient of a region do not count. The exit code is 0 whatever is found.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
