#pragma once

#include <QIcon>

namespace mien {

enum class Symbol { Play, Pause, First, Loop, Reset, Close, Open, Detach };

/// A symbol drawn as lines in the palette's text colour, sharp at every size and resolution.
QIcon icon(Symbol symbol);

}  // namespace mien
