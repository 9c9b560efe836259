#pragma once

#include <string>

namespace mien {

/// Keeps what VTK would print to the console. Errors that matter come as a Failure in our own words.
void keepConsoleMessages();

/// What was kept so far. After a command that succeeded there should be nothing.
const std::string& consoleMessages();

}  // namespace mien
