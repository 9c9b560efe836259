#pragma once

#include "FaceTemplate.h"
#include "MienAcquisitionModule.h"

namespace mien {

/// The generic face that is compiled in.
MIENACQUISITION_EXPORT const FaceCurves& referenceFace();

/// Its 68 landmarks (mm).
MIENACQUISITION_EXPORT const FaceLandmarks& referenceLandmarks();

/// Its front with the landmarks, as it is laid over scans.
MIENACQUISITION_EXPORT const FaceTemplate& referenceTemplate();

}  // namespace mien
