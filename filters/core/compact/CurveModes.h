#pragma once

#include "ClosedCurves.h"

namespace mien {

/// The curves with their Fourier modes 0 .. N alone, as many points as before, in their order down the face.
///
/// @param modes  N, 0 .. K / 2; at K / 2 nothing is left out
ClosedCurves firstModes(const ClosedCurves& curves, int modes);

/// Numbers that the first N modes of a face have: 29 curves of 2 N + 1 points in space, and no more than K points each.
int modeNumberCount(int pointsPerCurve, int modes);

}  // namespace mien
