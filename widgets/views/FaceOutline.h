#pragma once

#include <algorithm>
#include <array>
#include <vector>

class vtkPolyData;

namespace mien {

class FaceModel;

using SeenPoints = std::vector<std::array<double, 3>>;  ///< mm

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
  void add(const ViewAxes& axes, const double point[3], double room = 0.0);  ///< with room around it in the view

  double size(int axis) const { return high[axis] - low[axis]; }
  double middle(int axis) const { return 0.5 * (low[axis] + high[axis]); }
};

/// The corners of a box, x, y, z from and to, with a little room around it.
SeenPoints cornersAround(const double* bounds);

/// The points of a mesh that reach furthest up, down and to both sides in the views from the front, 45 degrees and the
/// side; of a head, where the face lies in its place, above the chin alone and no further from the face than a head
/// reaches.
SeenPoints furthestPoints(vtkPolyData* mesh);
SeenPoints furthestOfHead(vtkPolyData* mesh, const FaceModel& model);

/// Of the neutral curves alone.
FaceOutline restingOutline(const ViewAxes& axes, const FaceModel& model);

/// What a view must hold: the face at rest with room around it, and all that it reaches while it moves.
/// @param seen      at whose middle the camera looks
/// @param distance  from there, mm
FaceOutline outlineOf(const ViewAxes& axes, const FaceModel& model, const FaceOutline& seen, double distance);

}  // namespace mien
