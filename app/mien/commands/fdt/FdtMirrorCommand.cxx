#include <CLI/CLI.hpp>
#include <memory>

#include "FdtCommands.h"
#include "TableInput.h"
#include "TableOutput.h"

namespace mien {

namespace {

struct FdtMirrorCommandOptions {
  std::string table;
  MarkerFileOptions reading;
  TableOutput output;
};

void run(const FdtMirrorCommandOptions& options) {
  options.output.check();
  const FacialRegions regions = options.reading.regions();
  const DeformationTable table = readTable(options.table), mirrored = regions.mirrored(table);
  options.output.write(mirrored, "Mirror image of " + options.table + "; Mien " MIEN_VERSION);
  Report report;
  double largest = 0.0;
  report.rows = nlohmann::ordered_json::array();
  for (int region = 1; region <= FacialRegions::count; ++region) {
    const Eigen::Vector2d& centre = regions.centre(region);
    const Eigen::Vector2d before = table.maps[region - 1].apply(centre),
                          after = mirrored.maps[region - 1].apply(centre);
    largest = std::max(largest, (before - after).norm());
    report.rows.push_back({{"region", std::to_string(region) + " " + regions.name(region)},
                           {"mirror_of", regions.mirrored(region)},
                           {"asymmetry", (before - after).norm()}});
  }
  report.json = {{"table", options.table}, {"largest_asymmetry", largest}, {"regions", report.rows}};
  report.remarks = {
      "asymmetry: distance between where the table and its mirror image take the region's centre, pupil units"};
  options.output.print(report);
}

}  // namespace

void addFdtMirrorCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtMirrorCommandOptions>();
  CLI::App* command = parent.add_subcommand("mirror", "The table of the mirrored face");
  command->add_option("table", options->table, "Table")->required();
  options->output.addTo(*command, "Table to write, FILE.csv", true);
  options->reading.addRegionsTo(*command);
  command->footer(
      "Example: mien fdt mirror smile -o mirrored.csv\n"
      "         mien fdt blend smile:0.5 mirrored.csv:0.5 -o even_smile.csv");
  command->callback([options] { run(*options); });
}

}  // namespace mien
