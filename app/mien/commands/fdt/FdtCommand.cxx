#include <CLI/CLI.hpp>

#include "Command.h"
#include "FdtCommands.h"

namespace mien {

void addFdtCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "fdt", "Facial deformation tables: expressions as quadratic maps of 16 regions, fitted, applied, recognised");
  command->require_subcommand(1);
  addFdtFitCommand(*command);
  addFdtMeanCommand(*command);
  addFdtApplyCommand(*command);
  addFdtClassifyCommand(*command);
  addFdtCheckCommand(*command);
  addFdtShowCommand(*command);
  addFdtMirrorCommand(*command);
  addFdtBlendCommand(*command);
  addFdtFromFapCommand(*command);
  addFdtPackCommand(*command);
  command->footer(
      "A TABLE is a .csv file, or one that is compiled in: joy, sadness, anger, fear, disgust, surprise (means of 12 "
      "subjects)\n"
      "and smile (the published one). doc/deformation_tables.md describes the files of tables, markers and regions; a "
      "table's\n"
      "column displacement is the largest displacement it was fitted to: 1.5 times that is the most it moves a point.\n"
      "mien fdt COMMAND --help explains a command and gives an example.");
}

}  // namespace mien
