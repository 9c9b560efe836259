#pragma once

#include <string>

namespace mien {

/// Whether what may be the name of a file (FaceDeformation::table, FaceState::textureMesh) is instead what such a file
/// holds: it has several lines. So a state carries what nobody has saved yet.
bool isInlineText(const std::string& nameOrText);

}  // namespace mien
