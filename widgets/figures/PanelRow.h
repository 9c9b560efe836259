#pragma once

#include <string>
#include <vector>

#include "Plate.h"

namespace mien {

/// Panels side by side as one panel with one label: a row of a table of pictures. Their headings stand above them.
///
/// @param width  of the row, mm
PlatePanel panelRow(const std::string& heading, const std::vector<PlatePanel>& panels, double width);

}  // namespace mien
