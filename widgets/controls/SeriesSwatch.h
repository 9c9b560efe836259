#pragma once

#include <QIcon>
#include <QSize>

namespace mien {

constexpr QSize swatchSize(34, 12);  ///< pixels

/// Line and marker of a series in the screen's theme, for lists that are legends.
/// @param style  as SeriesStyle counts them; below 0: an empty place
QIcon seriesSwatch(int style);

}  // namespace mien
