#pragma once

#include <vector>

#include "DeformationFigure.h"
#include "DeformedFace.h"

namespace mien {

/// What applying a table does to the generic face, as arrows for a figure.
struct FaceArrows {
  std::vector<DeformationArrow> arrows;
  double pupilUnit = 0.0;  ///< of the face, mm
};

/// @param spacing  between arrows, pupil units
FaceArrows genericFaceArrows(const DeformationTable& table, const DeformationOptions& options, double spacing);

}  // namespace mien
