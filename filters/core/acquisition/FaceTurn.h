#pragma once

#include "FaceLandmarks.h"

namespace mien {

/// The rotation from a face that looks along +z, upright, to this one, by the landmarks of facePose().
Eigen::Matrix3d faceRotation(const FaceLandmarks& landmarks);

/// Whether the nose points away from where the eyes and the chin say that the face looks: it is mirrored, or left and
/// right landmarks are exchanged.
bool isMirrored(const FaceLandmarks& landmarks);

}  // namespace mien
