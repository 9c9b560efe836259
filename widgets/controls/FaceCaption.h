#pragma once

#include <string>
#include <vector>

#include "Figure.h"

namespace mien {

class FaceModel;

/// Says in a figure about the surface of which face it is: what moves it in the title, all that makes it in the note.
/// Deformation tables bend what comes after that surface and are left out.
/// @param schemes         of the surfaces that are shown
/// @param hasOneSmoothing  whether all are of the model's a
void describeFace(const FaceModel& model, const std::vector<std::string>& schemes, bool hasOneSmoothing,
                  Figure& figure);

}  // namespace mien
