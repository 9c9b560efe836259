#pragma once

#include <string>

namespace mien {

/// Whether a deformation table's text (FaceDeformation::table) is no name but the table itself: it has several lines.
bool isInlineTable(const std::string& text);

/// What to call it: names and weights as they are; of a table itself its first line, a comment, up to a colon.
std::string tableTitle(const std::string& text);

}  // namespace mien
