#include "FaceTurn.h"

#include <Eigen/Geometry>

namespace mien {

Eigen::Matrix3d faceRotation(const FaceLandmarks& landmarks) {
  const Eigen::Vector3d aside =
      (landmarks[45] - landmarks[36] + landmarks[42] - landmarks[39] + landmarks[54] - landmarks[48])
          .stableNormalized();
  const Eigen::Vector3d line = landmarks[27] - landmarks[8];
  const Eigen::Vector3d up = (line - line.dot(aside) * aside).stableNormalized();
  Eigen::Matrix3d levelled;
  levelled << aside, up, aside.cross(up);
  FaceLandmarks level = landmarks;
  level.points = landmarks.points * levelled;
  // What is left is how the line from chin to bridge leans on a face that looks forward.
  return levelled * Eigen::AngleAxisd(facePose(level).pitch, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

bool isMirrored(const FaceLandmarks& landmarks) {
  const Eigen::Vector3d nose = landmarks[30] - 0.5 * (landmarks[36] + landmarks[45]);
  return !(nose.dot(faceRotation(landmarks).col(2)) > 0.0);
}

}  // namespace mien
