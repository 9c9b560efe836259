#pragma once

#include <QImage>

#include "Plate.h"

namespace mien {

/// A panel that holds a picture of dots, such as a rendered face, as high as the picture asks for.
PlatePanel picturePanel(const std::string& heading, const QImage& picture);

}  // namespace mien
