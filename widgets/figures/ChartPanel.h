#pragma once

#include "Chart.h"
#include "Plate.h"

namespace mien {

/// A panel that holds a chart with its legend.
///
/// @param shape  height over width
PlatePanel chartPanel(const Chart& chart, double shape = 0.5);

}  // namespace mien
