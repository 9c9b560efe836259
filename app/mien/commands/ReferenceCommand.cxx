#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>

#include "Command.h"
#include "CommandDescription.h"
#include "OutputFile.h"
#include "ReferenceFormats.h"

namespace mien {

namespace {

struct ReferenceCommandOptions {
  std::string format = "markdown", output;
};

std::string manualPageOfThis(const CommandDescription& program) {
  return manualPage(program, MIEN_VERSION);
}

using Writer = std::string (*)(const CommandDescription&);
const std::map<std::string, Writer> writers = {
    {"markdown", markdownReference}, {"man", manualPageOfThis}, {"bash", bashCompletion}, {"zsh", zshCompletion}};

void run(const CLI::App& program, const ReferenceCommandOptions& options) {
  const std::string text = writers.at(options.format)(describeCommand(program));
  if (options.output.empty())
    std::cout << text;
  else
    OutputFile::write(options.output, text);
}

}  // namespace

void addReferenceCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("reference", "Print the reference of all commands");
  command->group("");  // for those who build and package Mien
  const auto options = std::make_shared<ReferenceCommandOptions>();
  command
      ->add_option("--format", options->format,
                   "A page in Markdown, a manual page, or a script that completes commands in a shell")
      ->check(CLI::IsMember({"markdown", "man", "bash", "zsh"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "File to write [standard output]");
  command->footer(
      "Example: mien reference --format markdown -o doc/manual/commands.md\n"
      "         mien reference --format man -o mien.1");
  command->callback([&program, options] { run(program, *options); });
}

}  // namespace mien
