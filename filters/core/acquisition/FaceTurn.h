#pragma once

#include "FaceLandmarks.h"

namespace mien {

/// The rotation from a face that looks along +z, upright, to this one, by the landmarks of facePose(): roll, yaw and
/// pitch, R = roll yaw pitch. Yaw and pitch of at most `least` radians count as none.
Eigen::Matrix3d faceRotation(const FaceLandmarks& landmarks, double least = 0.0);

/// Whether the nose points away from where the eyes and the chin say that the face looks: it is mirrored, or left and
/// right landmarks are exchanged.
bool isMirrored(const FaceLandmarks& landmarks);

}  // namespace mien
