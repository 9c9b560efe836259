#pragma once

#include <string>

#include "Figure.h"
#include "Plate.h"

namespace mien {

/// A panel that holds charts side by side with one legend, laid out as on their own.
///
/// @param width        of the panel, mm: it decides the height
/// @param heightShare  of the height that the charts would have on their own
PlatePanel figurePanel(const std::string& heading, const Figure& figure, double width, double heightShare = 1.0);

}  // namespace mien
