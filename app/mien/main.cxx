#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <new>

#include "Command.h"
#include "ConsoleMessages.h"
#include "Failure.h"
#include "InputGuard.h"

namespace {

constexpr int wrongFile = 1;
constexpr int wrongOption = 2;

int complain(const std::string& sentence, int exitCode) {
  std::cerr << "mien: " << sentence << "\n";
  return exitCode;
}

void addCommands(CLI::App& program) {
  mien::addInfoCommand(program);
  mien::addSurfaceCommand(program);
  mien::addCurvesCommand(program);
  mien::addPatchCommand(program);
  mien::addRenderCommand(program);
  mien::addAnimateCommand(program);
  mien::addConvertCommand(program);
  mien::addAcquireCommand(program);
  mien::addAdaptCommand(program);
  mien::addEditCommand(program);
  mien::addContinuityCommand(program);
  mien::addSpectrumCommand(program);
  mien::addSweepCommand(program);
  mien::addInfluenceCommand(program);
  mien::addEnsembleCommand(program);
  mien::addCompareCommand(program);
  mien::addVectorsCommand(program);
  mien::addTextureCommand(program);
  mien::addLodCommand(program);
  mien::addFatCommand(program);
  mien::addFdtCommand(program);
  mien::addFigureCommand(program);
  mien::addReferenceCommand(program);
}

/// No command may write over what it reads: a mistyped -o would cost a recording.
void guardInputs(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands(nullptr)) {
    guardInputs(*command);
    command->parse_complete_callback([command] { mien::refuseToOverwrite(*command); });
  }
}

/// An argument that is neither an option nor a command where one belongs, which CLI11 would only call missing.
std::string unknownCommand(const CLI::App& program, int argc, char** argv, int at = 1) {
  if (argc <= at || argv[at][0] == '-' || program.get_require_subcommand_min() == 0) return {};
  std::string names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->get_name() == argv[at]) return unknownCommand(*command, argc, argv, at + 1);
    if (!command->get_group().empty()) names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return "there is no command '" + (at > 1 ? program.get_name() + " " : "") + argv[at] + "'; the commands are " + names;
}

/// The command that the arguments name, for a hint on where its options are explained.
std::string usedCommand(const CLI::App& program) {
  std::string name = "mien";
  const CLI::App* last = &program;
  while (!last->get_subcommands().empty()) {
    last = last->get_subcommands().front();
    name += " " + last->get_name();
  }
  return name;
}

int run(CLI::App& program, int argc, char** argv) {
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return complain(std::string(error.what()) + "; see " + usedCommand(program) + " --help", wrongOption);
  } catch (const mien::Failure& failure) {
    return complain(failure.what(), failure.exitCode());
  } catch (const std::bad_alloc&) {
    return complain("there is not enough memory; choose a smaller --resolution or --size", wrongFile);
  } catch (const std::exception& error) {
    return complain(std::string("stopped by an unexpected fault (") + error.what() +
                        "); please report it with the files that show it",
                    wrongFile);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Mien: PDE face surfaces, animated by MPEG-4 facial animation parameters", "mien");
  program.set_version_flag("--version", "mien " MIEN_VERSION);
  program.require_subcommand(1);
  program.footer("mien COMMAND --help explains a command and gives an example.");
  addCommands(program);
  guardInputs(program);
  const std::string unknown = unknownCommand(program, argc, argv);
  if (!unknown.empty()) return complain(unknown, wrongOption);
  mien::keepConsoleMessages();
  const int exitCode = run(program, argc, argv);
  std::cout.flush();
  if (exitCode == 0 && !std::cout)
    return complain("the results cannot be written to standard output; is it closed, or the disk full?", wrongFile);
  if (exitCode == 0) std::cerr << mien::consoleMessages();
  return exitCode;
}
