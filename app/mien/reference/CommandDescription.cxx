#include "CommandDescription.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <tuple>

namespace mien {

namespace {

constexpr const char* groupOfCli = "Options";

/// CLI11 keeps them by address, in another order each time.
std::vector<std::string> sortedNames(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> optionNames(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_name(true)};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

OptionDescription describeOption(const CLI::Option& option) {
  OptionDescription described;
  described.names = optionNames(option);
  described.help = option.get_description();
  described.needs = sortedNames(option.get_needs());
  described.excludes = sortedNames(option.get_excludes());
  described.required = option.get_required();
  if (option.get_group() != groupOfCli) described.group = option.get_group();
  if (option.get_type_size() == 0) return described;
  const std::string type = option.get_type_name();
  const size_t colon = std::min(type.find(':'), type.size());
  described.value = type.substr(0, colon);
  if (colon < type.size()) described.limits = type.substr(colon + 1);
  described.usual = option.get_default_str();
  described.repeats = option.get_expected_max() == CLI::detail::expected_max_vector_size;
  return described;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string pathOf(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent ? pathOf(*parent) + " " + command.get_name() : command.get_name();
}

}  // namespace

bool OptionDescription::operator==(const OptionDescription& other) const {
  const auto all = [](const OptionDescription& o) {
    return std::tie(o.names, o.group, o.value, o.limits, o.usual, o.help, o.needs, o.excludes, o.required, o.repeats);
  };
  return all(*this) == all(other);
}

std::string OptionDescription::namesText() const {
  return listed(names);
}

std::string OptionDescription::text() const {
  std::string told = help;
  if (!limits.empty()) told += " (" + limits + ")";
  if (!usual.empty()) told += " [" + usual + "]";
  if (!needs.empty()) told += "; needs " + listed(needs);
  if (!excludes.empty()) told += "; not with " + listed(excludes);
  return told;
}

std::string CommandDescription::usage() const {
  std::string line = path;
  if (!options.empty()) line += " [OPTIONS]";
  if (!commands.empty()) line += " COMMAND";
  for (const OptionDescription& argument : arguments) {
    const std::string name = argument.longestName() + (argument.repeats ? "..." : "");
    line += argument.required ? " " + name : " [" + name + "]";
  }
  return line;
}

CommandDescription describeCommand(const CLI::App& command) {
  CommandDescription described;
  described.path = pathOf(command);
  described.summary = command.get_description();
  described.footer = command.get_footer();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? described.arguments : described.options).push_back(describeOption(*option));
  }
  for (const CLI::App* below : command.get_subcommands(nullptr))
    if (!below->get_group().empty()) described.commands.push_back(describeCommand(*below));
  return described;
}

std::vector<const CommandDescription*> withAllBelow(const CommandDescription& command) {
  std::vector<const CommandDescription*> all = {&command};
  for (const CommandDescription& below : command.commands) {
    const std::vector<const CommandDescription*> more = withAllBelow(below);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace mien
