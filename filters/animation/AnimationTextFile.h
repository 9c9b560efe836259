#pragma once

#include <string>

#include "MienAnimationModule.h"

namespace mien {

/// Reads a file whole, or as far as is needed to tell that no parser takes it; "-" is standard input.
/// @return nothing, or what is wrong and what to do, without the name of the file
MIENANIMATION_EXPORT std::string readAnimationText(const std::string& name, std::string& text);

/// The name of such a file in messages: "-" is "standard input".
MIENANIMATION_EXPORT std::string shownAnimationName(const std::string& name);

}  // namespace mien
