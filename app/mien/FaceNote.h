#pragma once

#include <string>
#include <vector>

#include "FaceState.h"

namespace mien {

/// For the notes of figures: "Generic face, scheme spline; a = 1; N = 5 with remainder; joy at 1; Mien 0.1".
std::string faceNote(const FaceState& state, const std::vector<std::string>& schemes, bool withSmoothing = true);

/// Whether all patches have the same a.
bool hasUniformSmoothing(const FaceSurfaceOptions& options);

}  // namespace mien
