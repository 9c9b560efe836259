#pragma once

#include "FaceTemplate.h"
#include "Progress.h"
#include "SkinMatches.h"

namespace mien {

/// Stretches and bends a face that lies over a scan as a whole, by cubic polynomials of its coordinates, towards the
/// tangent planes of the skin: brows, nose, mouth and chin come near their own folds before the face is bent in detail.
/// @param moved  the vertices of the template where they lie over the scan; moved further
/// @return whether it ran to its end
bool alignSmoothly(const FaceTemplate& face, const SkinMatches& skin, TriangleMesh& moved, double reach,
                   const Progress& progress = {});

}  // namespace mien
