#include "SharedOptions.h"

#include <algorithm>

namespace mien {

namespace {

/// An option of fewer commands is explained with each.
constexpr size_t fewestCommands = 3;

void add(const OptionDescription& option, std::vector<SharedOptions::Group>& groups) {
  const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == option.group; });
  if (known == groups.end())
    groups.push_back({option.group, {option}});
  else
    known->options.push_back(option);
}

}  // namespace

SharedOptions::SharedOptions(const CommandDescription& program) {
  const std::vector<const CommandDescription*> commands = withAllBelow(program);
  const auto has = [](const CommandDescription* command, const OptionDescription& option) {
    return std::find(command->options.begin(), command->options.end(), option) != command->options.end();
  };
  for (const CommandDescription* command : commands)
    for (const OptionDescription& option : command->options) {
      if (contains(option)) continue;
      const auto uses = std::count_if(commands.begin(), commands.end(), [&](auto other) { return has(other, option); });
      if (static_cast<size_t>(uses) >= fewestCommands) add(option, groups_);
    }
}

bool SharedOptions::contains(const OptionDescription& option) const {
  return std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    return std::find(group.options.begin(), group.options.end(), option) != group.options.end();
  });
}

std::vector<SharedOptions::Group> SharedOptions::own(const CommandDescription& command) const {
  return chosen(command, false);
}

std::vector<SharedOptions::Group> SharedOptions::sharedBy(const CommandDescription& command) const {
  return chosen(command, true);
}

std::vector<SharedOptions::Group> SharedOptions::chosen(const CommandDescription& command, bool shared) const {
  std::vector<Group> groups;
  for (const OptionDescription& option : command.options)
    if (contains(option) == shared) add(option, groups);
  return groups;
}

}  // namespace mien
