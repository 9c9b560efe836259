#pragma once

#include <string>
#include <vector>

#include "CommandDescription.h"

namespace mien {

/// The words that a shell can complete as the value of an option or argument of a command: those it is declared with,
/// those of the program's own lists (expressions, visemes, tables, figures), or those its help lists. Empty: a file or
/// a value of one's own.
std::vector<std::string> valueChoices(const CommandDescription& command, const OptionDescription& option);

}  // namespace mien
