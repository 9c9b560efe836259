#pragma once

#include <QImage>

#include "FaceState.h"

namespace mien {

/// Mien Studio's window with that face, drawn by the mien-studio beside this program. Needs a display (VirtualDisplay).
/// Throws a FileFailure when there is no mien-studio or it does not answer.
QImage studioPicture(const FaceState& state);

}  // namespace mien
