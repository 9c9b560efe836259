#pragma once

namespace CLI {
class App;
}

namespace mien {

/// Throws a ValueFailure when a file that -o/--output of a parsed command names is, by any path, one that another of
/// its arguments names: the result would replace what it was made from.
void refuseToOverwrite(const CLI::App& command);

}  // namespace mien
