#pragma once

#include <set>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace mien {

/// The command as it was asked for, so that what it made can be made again: "mien vectors --expression joy -o joy.svg".
/// @param without  options that are left out (long names)
std::string commandText(const CLI::App& command, const std::set<std::string>& without = {});

/// The command with other words in place of its positional ones and without some options (long names).
std::string commandText(const CLI::App& command, const std::vector<std::string>& positionals,
                        const std::set<std::string>& without);

/// The words of such a text, without their quotes.
std::vector<std::string> commandWords(const std::string& text);

}  // namespace mien
