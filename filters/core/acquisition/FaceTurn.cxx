#include "FaceTurn.h"

#include <Eigen/Geometry>
#include <cmath>

namespace mien {

namespace {

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d& axis, double least) {
  return Eigen::AngleAxisd(std::abs(angle) > least ? angle : 0.0, axis).toRotationMatrix();
}

}  // namespace

Eigen::Matrix3d faceRotation(const FaceLandmarks& landmarks, double least) {
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
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d rotation = levelled * turn(facePose(level).pitch, x, 0.0);
  const double yaw = std::atan2(-aside.z(), aside.head<2>().norm());
  const Eigen::Matrix3d rolled = turn(std::atan2(aside.y(), aside.x()), z, 0.0);
  const Eigen::Matrix3d rest = (rolled * turn(yaw, y, 0.0)).transpose() * rotation;
  return rolled * turn(yaw, y, least) * turn(std::atan2(rest(2, 1), rest(1, 1)), x, least);
}

bool isMirrored(const FaceLandmarks& landmarks) {
  const Eigen::Vector3d nose = landmarks[30] - 0.5 * (landmarks[36] + landmarks[45]);
  return !(nose.dot(faceRotation(landmarks).col(2)) > 0.0);
}

}  // namespace mien
