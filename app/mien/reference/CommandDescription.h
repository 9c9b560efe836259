#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mien {

/// An option or an argument of a command, as the program declares it.
struct OptionDescription {
  std::vector<std::string> names;  ///< "-a", "--smoothing"; an argument has one, without dashes
  std::string group;               ///< "Face"; empty for those of one command
  std::string value;               ///< "TEXT", "INT"; empty for flags
  std::string limits;              ///< what the value may be, where the option is declared so: "{single,double}"
  std::string usual;               ///< the value without the option, where it is declared and not told by the help
  std::string help;
  std::vector<std::string> needs, excludes;  ///< longest names of other options, sorted
  bool required = false;
  bool repeats = false;  ///< takes any number of values

  bool operator==(const OptionDescription& other) const;

  /// "-a, --smoothing".
  std::string namesText() const;

  /// The name that says most: "--smoothing".
  const std::string& longestName() const { return names.back(); }

  /// What is told of it: its help with the usual value, its limits and the options it goes or does not go with.
  std::string text() const;
};

/// A command of the program and those below it.
struct CommandDescription {
  std::string path;  ///< "mien fdt fit"
  std::string summary;
  std::string footer;
  std::vector<OptionDescription> arguments, options;
  std::vector<CommandDescription> commands;

  /// "mien fdt fit [OPTIONS] [recording]".
  std::string usage() const;
};

/// The program and all its commands, without those that are hidden.
CommandDescription describeCommand(const CLI::App& command);

/// A command and all below it, in the order of their declaration.
std::vector<const CommandDescription*> withAllBelow(const CommandDescription& command);

}  // namespace mien
