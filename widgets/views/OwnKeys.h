#pragma once

namespace mien {

/// Dynamic property of a widget that answers keys itself: a QStringList of texts such as "Left, Right: the frame
/// before, the next one". The window's list of shortcuts shows them.
constexpr const char* ownKeys = "ownKeys";

}  // namespace mien
