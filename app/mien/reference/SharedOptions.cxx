#include "SharedOptions.h"

#include <algorithm>
#include <cstddef>

namespace mien {

namespace {

/// An option of fewer commands is explained with each.
constexpr std::ptrdiff_t fewestCommands = 3;

void add(const OptionDescription& option, std::vector<SharedOptions::Group>& groups) {
  const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.name == option.group; });
  if (known == groups.end())
    groups.push_back({option.group, {option}});
  else
    known->options.push_back(option);
}

/// One that other commands declare otherwise is shared only where most declare it so: a name stands for one thing.
bool isShared(const OptionDescription& option, const std::vector<OptionDescription>& all) {
  const auto alike = std::count(all.begin(), all.end(), option);
  const auto named = std::count_if(all.begin(), all.end(),
                                   [&](const OptionDescription& o) { return o.longestName() == option.longestName(); });
  return alike >= fewestCommands && 2 * alike > named;
}

}  // namespace

SharedOptions::SharedOptions(const CommandDescription& program) {
  std::vector<OptionDescription> all;
  for (const CommandDescription* command : withAllBelow(program))
    all.insert(all.end(), command->options.begin(), command->options.end());
  for (const OptionDescription& option : all)
    if (!contains(option) && isShared(option, all)) add(option, groups_);
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
