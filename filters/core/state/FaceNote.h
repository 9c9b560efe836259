#pragma once

#include <string>
#include <vector>

#include "FaceState.h"

namespace mien {

/// What moves the face, in words: "frame 120 of talk.fap, joy at 0.8, viseme p b m, FAP 3 = 300, deformation table
/// smile"; empty for a face at rest. Of files the last part of the name.
/// @param frames    "frames 100, 120" in place of the frame that the state chooses
/// @param mostFAPs  of more values than that only their number is told
std::string motionText(const FaceState& state, const std::string& frames = {}, size_t mostFAPs = 8);

/// For the notes of figures, everything that makes the face: "Generic face, scheme spline; a = 1; N = 5 with remainder;
/// joy; Mien 0.1".
/// @param frames  as in motionText()
std::string faceNote(const FaceState& state, const std::vector<std::string>& schemes, bool withSmoothing = true,
                     const std::string& frames = {});

/// Whether all patches have the same a.
bool hasUniformSmoothing(const FaceSurfaceOptions& options);

}  // namespace mien
