#pragma once

#include <string>

#include "CompactFace.h"
#include "MienSurfaceModule.h"

/// Compact face files (.mienz) on disk; the format stands in CompactFace.h.
namespace mien {

/// Whether a file is to be read as a compact face: by its ending, or by its first bytes.
MIENSURFACE_EXPORT bool isCompactFaceFile(const std::string& name);

/// @return nothing, or "FILE: " and one sentence that says what is wrong; `compact` is then left alone
MIENSURFACE_EXPORT std::string readCompactFaceFile(const std::string& name, CompactFace& compact);

}  // namespace mien
