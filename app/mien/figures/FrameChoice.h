#pragma once

#include <vector>

#include "FaceState.h"

namespace mien {

class FigureContext;

/// The states of an animation that a figure shows: frames of --frames, else the strongest frame of each of `count`
/// equal parts between the shares `begin` and `end` of the file. Without a file, of the animation that comes with Mien.
/// Throws a FileFailure or a ValueFailure.
std::vector<FaceState> animationStates(FigureContext& context, int count, double begin, double end);

/// "frame 120"
std::string frameHeading(const FaceState& state);

}  // namespace mien
