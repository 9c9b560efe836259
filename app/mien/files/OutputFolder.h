#pragma once

#include <string>

namespace mien {

/// Makes a folder for output unless there is one; the folder above it must be there. Throws a FileFailure.
void makeFolder(const std::string& name);

}  // namespace mien
