#pragma once

#include <Eigen/Core>
#include <string>

#include "HeadAxis.h"

namespace mien {

/// The 68 landmarks of Multi-PIE (Gross et al. 2010) on a scan: 0-16 jaw line, 17-26 brows, 27-35 nose, 36-47 eyes,
/// 48-67 lips. Numbers run from the subject's right (-x) to the left, lips clockwise as seen from the front.
struct FaceLandmarks {
  static constexpr int count = 68;
  using Points = Eigen::Matrix<double, count, 3, Eigen::RowMajor>;

  Points points = Points::Zero();  ///< mm

  Eigen::Vector3d operator[](int landmark) const { return points.row(landmark); }
};

/// The landmark on the other side of the face; itself on the midline.
int mirrorLandmark(int landmark);

/// The mean of landmarks and their mirror image in x.
FaceLandmarks symmetrised(const FaceLandmarks& landmarks);

/// The distance of the outer eye corners, mm.
double eyeDistance(const FaceLandmarks& landmarks);

/// The axis the face is measured from: x on the midline of nose and lips, z behind the eyes by 0.7 of the distance of
/// their outer corners.
HeadAxis headAxis(const FaceLandmarks& landmarks);

/// How far a face looks away from +z, radians.
struct FacePose {
  double yaw = 0.0;    ///< positive: to the subject's left
  double pitch = 0.0;  ///< positive: down
};

/// The pose by eye and mouth corners (yaw) and by nose bridge and chin (pitch, which leans by 1.5 degrees on the
/// generic face looking forward). Roll, about z, is not told.
FacePose facePose(const FaceLandmarks& landmarks);

/// One sentence that says which landmark is unusable (not finite, or in the wrong order down the face), or nothing.
std::string describeFault(const FaceLandmarks& landmarks);

}  // namespace mien
