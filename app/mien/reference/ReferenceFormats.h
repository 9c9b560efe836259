#pragma once

#include <string>

#include "CommandDescription.h"

namespace mien {

/// A page in Markdown: every command with its options, notes and examples; options of many commands once.
std::string markdownReference(const CommandDescription& program);

/// A manual page in the macros of man(7), section 1.
/// @param version that of the program, "0.1.0"
std::string manualPage(const CommandDescription& program, const std::string& version);

/// A script that completes commands, options, values and files in bash.
std::string bashCompletion(const CommandDescription& program);

/// The same for zsh, with the help of every option.
std::string zshCompletion(const CommandDescription& program);

}  // namespace mien
