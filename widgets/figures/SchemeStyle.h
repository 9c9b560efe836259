#pragma once

#include <string>

namespace mien {

/// The style of a scheme's series, the same in all figures whatever schemes they show.
int schemeStyle(const std::string& scheme);

}  // namespace mien
