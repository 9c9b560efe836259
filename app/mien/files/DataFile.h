#pragma once

#include <string>

namespace mien {

/// Where a file that comes with Mien is, such as "animation/demo.fap": beside the installed program, else in the source
/// tree that the program was built from; "" when it is in neither.
std::string findDataFile(const std::string& name);

}  // namespace mien
