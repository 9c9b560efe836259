#pragma once

#include <string>

namespace CLI {
class App;
}

namespace mien {

/// The command as it was asked for, so that what it made can be made again: "mien vectors --expression joy -o joy.svg".
std::string commandText(const CLI::App& command);

}  // namespace mien
