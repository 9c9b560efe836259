#pragma once

#include <string>

#include "MienTextureModule.h"

namespace mien {

/// Reads a small text file: nothing, or `FILE: what is wrong and what to do`; `what` names its content ("warp mesh").
MIENTEXTURE_EXPORT std::string readSmallTextFile(const std::string& name, const std::string& what, std::string& text);

}  // namespace mien
