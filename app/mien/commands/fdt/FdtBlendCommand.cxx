#include <CLI/CLI.hpp>
#include <memory>

#include "FdtCommands.h"
#include "TableInput.h"
#include "TableOutput.h"

namespace mien {

namespace {

struct FdtBlendCommandOptions {
  std::vector<std::string> tables;
  TableOutput output;
};

void run(const FdtBlendCommandOptions& options) {
  options.output.check();
  const DeformationTable table = readWeightedTables(options.tables);
  std::string names;
  for (const std::string& text : options.tables) names += (names.empty() ? "" : " ") + text;
  options.output.write(table, "Blend of " + names + "; Mien " MIEN_VERSION);
  Report report;
  report.json = {{"tables", options.tables}, {"largest_displacement", table.largestDisplacement}};
  report.remarks = {"blended " + names};
  const std::string unknown = describeUnknown(table);
  if (!unknown.empty()) report.remarks.push_back(unknown);
  options.output.print(report);
}

}  // namespace

void addFdtBlendCommand(CLI::App& parent) {
  const auto options = std::make_shared<FdtBlendCommandOptions>();
  CLI::App* command = parent.add_subcommand("blend", "Add the displacements of tables, each times its weight");
  command->add_option("tables", options->tables, "TABLE[:WEIGHT] .., weights -2 .. 2, 1 without one")->required();
  options->output.addTo(*command, "Table to write, FILE.csv", true);
  command->footer(
      "Example: mien fdt blend joy:0.5 surprise:0.5 -o happy_surprise.csv\n"
      "Identity + sum of weight (table - identity): weights that sum to 1 mix tables, joy:0.5 alone is half a joy.");
  command->callback([options] { run(*options); });
}

}  // namespace mien
