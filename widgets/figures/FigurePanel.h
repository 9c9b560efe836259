#pragma once

#include <string>

#include "Figure.h"
#include "Plate.h"

namespace mien {

/// A panel that holds charts side by side with one legend, laid out as on their own.
///
/// @param width  of the panel, mm: it decides the height
PlatePanel figurePanel(const std::string& heading, const Figure& figure, double width);

}  // namespace mien
