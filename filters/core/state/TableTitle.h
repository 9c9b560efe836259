#pragma once

#include <string>

namespace mien {

/// What to call a deformation table (FaceDeformation::table): names and weights as they are; of a table itself
/// (InlineText.h) its first line, a comment, up to a colon.
std::string tableTitle(const std::string& text);

}  // namespace mien
