#pragma once

#include <string>
#include <vector>

#include "MotionVectorFigure.h"
#include "Plate.h"

namespace mien {

/// A panel that holds motion vector fields with one scale, one colour bar and one reference arrow.
///
/// @param options  its width is that of the panel, mm; its theme that of the plate
PlatePanel motionPanel(const std::string& heading, const std::vector<MotionVectorPanel>& fields,
                       const MotionVectorOptions& options);

}  // namespace mien
