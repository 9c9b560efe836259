#pragma once

#include <string>

namespace mien {

/// Throws a ValueFailure that names near ones when no font of this family is installed.
void requireFont(const std::string& option, const std::string& family);

}  // namespace mien
