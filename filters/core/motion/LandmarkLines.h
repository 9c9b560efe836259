#pragma once

#include <vector>

#include "FaceCurves.h"

namespace mien {

/// Lines by which a face is recognised, of its own boundary curves between feature points: lids (C9, C10), brows (C6),
/// outline of the nose's wings and base (C15 .. C18), lips (C21, C23); mm, one row per point. What lacks a feature
/// point is left out.
std::vector<ClosedCurves::Points> landmarkLines(const FaceCurves& face);

}  // namespace mien
