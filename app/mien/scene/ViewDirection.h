#pragma once

#include <string>

namespace mien {

/// Where the camera stands around the head, in degrees.
struct ViewDirection {
  double azimuth = 0.0;    ///< 0: in front, 90: at the subject's left
  double elevation = 0.0;  ///< 90: above

  /// From the head to the camera, unit length.
  void unitVector(double direction[3]) const;

  /// The three directions of the picture, unit length: to its right, up, and from the head to the camera.
  void axes(double right[3], double up[3], double out[3]) const;
};

/// front, back, left, right, side (the left), top, 45-right, or AZIMUTH[:ELEVATION] such as 45 or -30:15.
/// Throws a ValueFailure that lists them.
ViewDirection parseView(const std::string& text);

}  // namespace mien
