#pragma once

#include <QImage>
#include <string>

#include "PlaneDrawing.h"
#include "Plate.h"

namespace mien {

/// A picture with lines and marks drawn over it. The drawing is in pixels of the picture, y up from its lower edge;
/// its colours are those of the light theme, whatever the page.
PlatePanel overlaidPanel(const std::string& heading, const QImage& picture, const PlaneDrawing& drawing);

}  // namespace mien
