#pragma once

#include <algorithm>
#include <array>

namespace mien {

class FaceModel;

/// Of a camera that looks at the face from one side: 0 degrees from the front, 90 at the subject's left.
struct ViewAxes {
  double right[3], up[3] = {0.0, 1.0, 0.0}, out[3];

  explicit ViewAxes(double degrees);
};

/// The extent of the face along those axes, in mm.
struct FaceOutline {
  double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};

  void add(int axis, double at) {
    low[axis] = std::min(low[axis], at);
    high[axis] = std::max(high[axis], at);
  }
  void add(const ViewAxes& axes, const double point[3]);
  void add(const ViewAxes& axes, const std::array<double, 6>& box);  ///< with a little room around it

  double size(int axis) const { return high[axis] - low[axis]; }
  double middle(int axis) const { return 0.5 * (low[axis] + high[axis]); }
};

/// Of the neutral curves alone.
FaceOutline restingOutline(const ViewAxes& axes, const FaceModel& model);

/// What a view must hold: the face at rest with room around it, and all that it reaches while it moves.
/// @param seen      at whose middle the camera looks
/// @param distance  from there, mm
FaceOutline outlineOf(const ViewAxes& axes, const FaceModel& model, const FaceOutline& seen, double distance);

}  // namespace mien
