#pragma once

#include <string>
#include <vector>

#include "CommandDescription.h"

namespace mien {

/// The options that several commands have with the same meaning, so that a reference explains them once.
class SharedOptions {
 public:
  struct Group {
    std::string name;  ///< "Face"; empty for those outside groups
    std::vector<OptionDescription> options;
  };

  explicit SharedOptions(const CommandDescription& program);

  bool contains(const OptionDescription& option) const;

  /// In the order of their first use.
  const std::vector<Group>& groups() const { return groups_; }

  /// The command's own options in groups.
  std::vector<Group> own(const CommandDescription& command) const;

  /// The shared ones of a command, in groups.
  std::vector<Group> sharedBy(const CommandDescription& command) const;

 private:
  std::vector<Group> chosen(const CommandDescription& command, bool shared) const;

  std::vector<Group> groups_;
};

}  // namespace mien
