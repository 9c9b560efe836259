#pragma once

#include "FaceAnimator.h"
#include "FaceState.h"

namespace mien {

class FigureContext;

/// The neutral face of a figure with the animation table bound to it. Throws a FileFailure when that cannot be.
FaceAnimator boundFace(FigureContext& context);

}  // namespace mien
